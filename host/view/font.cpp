#include "host/view/font.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace isotouch::view {
namespace {

/// How a letter is drawn: `M` lifts the pen, `L x y …` draws straight lines, `A cx cy rx ry from to` an arc of an ellipse (degrees,
/// counter-clockwise when `to` is larger); a pen that is down is led to the arc's start in a straight line.
struct Drawing {
  char32_t character;
  float width;
  const char* path;
};

constexpr Drawing kDrawings[] = {
    {U' ', 1.4F, ""},
    {U'!', 0.4F, "M L .2 7 .2 2.2 M A .2 .2 .2 .2 0 360"},
    {U'"', 1.8F, "M L 0 7 0 5 M L 1.8 7 1.8 5"},
    {U'#', 4.6F, "M L 1.3 0 1.9 7 M L 3.1 0 3.7 7 M L .3 4.7 4.8 4.7 M L 0 2.3 4.5 2.3"},
    {U'$', 4.2F, "M A 2.1 4.8 1.9 1.4 40 270 A 2.1 2 2.1 1.4 90 -145 M L 2.1 7.4 2.1 -.6"},
    {U'%', 5.6F, "M A 1.2 5.5 1.2 1.5 0 360 M A 4.4 1.5 1.2 1.5 0 360 M L 4.8 7 .8 0"},
    {U'&', 4.8F, "M L 4.8 0 1 4.6 A 2 5.6 1.3 1.4 225 -45 L .9 3.1 A 1.9 1.75 1.9 1.75 130 300 L 4.7 3"},
    {U'\'', 0.2F, "M L .1 7 .1 5"},
    {U'(', 1.6F, "M A 3 3 3 5 125 235"},
    {U')', 1.6F, "M A -1.4 3 3 5 55 -55"},
    {U'*', 3.2F, "M L 1.6 7 1.6 4 M L .3 6.3 2.9 4.7 M L .3 4.7 2.9 6.3"},
    {U'+', 4.0F, "M L 0 3.2 4 3.2 M L 2 1.2 2 5.2"},
    {U',', 0.6F, "M L .5 .4 0 -1.3"},
    {U'-', 2.4F, "M L 0 2.8 2.4 2.8"},
    {U'.', 0.4F, "M A .2 .2 .2 .2 0 360"},
    {U'/', 3.0F, "M L 0 -1 3 7.6"},
    {U'0', 4.0F, "M A 2 3.5 2 3.5 0 360"},
    {U'1', 4.0F, "M L .7 5.6 2.3 7 2.3 0"},
    {U'2', 4.0F, "M A 2 5.1 1.9 1.9 165 -32 L .1 0 4 0"},
    {U'3', 4.0F, "M A 1.9 5.25 1.75 1.75 150 -90 A 1.9 1.75 2 1.75 90 -150"},
    {U'4', 4.2F, "M L 3.1 0 3.1 7 0 2 4.2 2"},
    {U'5', 4.0F, "M L 3.6 7 .7 7 .4 3.8 A 1.9 2.25 2.1 2.25 132 -148"},
    {U'6', 4.0F, "M A 3.4 2.2 3.4 4.8 92 180 A 2 2.2 2 2.2 180 540"},
    {U'7', 4.0F, "M L 0 7 4 7 1.3 0"},
    {U'8', 4.0F, "M A 2 5.3 1.7 1.7 270 -90 A 2 1.8 2 1.8 90 450"},
    {U'9', 4.0F, "M A .6 4.8 3.4 4.8 -88 0 A 2 4.8 2 2.2 0 360"},
    {U':', 0.4F, "M A .2 .2 .2 .2 0 360 M A .2 4.4 .2 .2 0 360"},
    {U';', 0.6F, "M L .5 .4 0 -1.3 M A .4 4.4 .2 .2 0 360"},
    {U'<', 3.4F, "M L 3.4 5.4 0 3.2 3.4 1"},
    {U'=', 4.0F, "M L 0 4.2 4 4.2 M L 0 2.2 4 2.2"},
    {U'>', 3.4F, "M L 0 5.4 3.4 3.2 0 1"},
    {U'?', 3.2F, "M A 1.6 5.4 1.6 1.6 165 -60 A 2.8 2.6 1.3 1.3 130 180 L 1.5 2.2 M A 1.5 .2 .2 .2 0 360"},
    {U'@', 6.4F, "M A 3.2 2.9 1.5 1.6 0 360 M L 4.7 4.5 4.7 2.2 A 5.5 2.2 .8 .9 180 360 A 3.2 2.9 3.2 3.6 0 300"},
    {U'A', 5.0F, "M L 0 0 2.5 7 5 0 M L .86 2.4 4.14 2.4"},
    {U'B', 4.0F, "M L 0 3.7 2.2 3.7 A 2.2 1.85 1.8 1.85 90 -90 L 0 0 0 7 1.9 7 A 1.9 5.35 1.6 1.65 90 -90"},
    {U'C', 4.7F, "M A 2.8 3.5 2.8 3.5 48 312"},
    {U'D', 4.6F, "M L 0 0 0 7 1.5 7 A 1.5 3.5 3.1 3.5 90 -90 L 0 0"},
    {U'E', 3.6F, "M L 3.6 7 0 7 0 0 3.6 0 M L 0 3.7 3 3.7"},
    {U'F', 3.5F, "M L 3.5 7 0 7 0 0 M L 0 3.6 3 3.6"},
    {U'G', 5.1F, "M A 2.8 3.5 2.8 3.5 48 325 L 5.1 3.2 3.1 3.2"},
    {U'H', 4.5F, "M L 0 0 0 7 M L 4.5 0 4.5 7 M L 0 3.6 4.5 3.6"},
    {U'I', 0.0F, "M L 0 0 0 7"},
    {U'J', 3.0F, "M L 3 7 3 1.6 A 1.5 1.6 1.5 1.6 0 -160"},
    {U'K', 4.4F, "M L 0 0 0 7 M L 4.2 7 0 2.6 M L 1.5 4.17 4.4 0"},
    {U'L', 3.4F, "M L 0 7 0 0 3.4 0"},
    {U'M', 5.6F, "M L 0 0 0 7 2.8 2 5.6 7 5.6 0"},
    {U'N', 4.6F, "M L 0 0 0 7 4.6 0 4.6 7"},
    {U'O', 5.6F, "M A 2.8 3.5 2.8 3.5 0 360"},
    {U'P', 4.1F, "M L 0 0 0 7 2.2 7 A 2.2 5.1 1.9 1.9 90 -90 L 0 3.2"},
    {U'Q', 5.6F, "M A 2.8 3.5 2.8 3.5 0 360 M L 3.6 1.7 5.4 -.5"},
    {U'R', 4.4F, "M L 0 0 0 7 2.2 7 A 2.2 5.1 1.9 1.9 90 -90 L 0 3.2 M L 2.1 3.2 4.4 0"},
    {U'S', 4.2F, "M A 2.1 5.25 1.9 1.75 38 270 A 2.1 1.75 2.1 1.75 90 -148"},
    {U'T', 4.8F, "M L 0 7 4.8 7 M L 2.4 7 2.4 0"},
    {U'U', 4.4F, "M L 0 7 0 2.2 A 2.2 2.2 2.2 2.2 180 360 L 4.4 7"},
    {U'V', 5.0F, "M L 0 7 2.5 0 5 7"},
    {U'W', 7.2F, "M L 0 7 1.8 0 3.6 6.4 5.4 0 7.2 7"},
    {U'X', 4.6F, "M L 0 0 4.6 7 M L 0 7 4.6 0"},
    {U'Y', 4.8F, "M L 0 7 2.4 3.3 4.8 7 M L 2.4 3.3 2.4 0"},
    {U'Z', 4.4F, "M L 0 7 4.3 7 0 0 4.4 0"},
    {U'[', 1.4F, "M L 1.4 7.6 0 7.6 0 -1.2 1.4 -1.2"},
    {U'\\', 3.0F, "M L 0 7.6 3 -1"},
    {U']', 1.4F, "M L 0 7.6 1.4 7.6 1.4 -1.2 0 -1.2"},
    {U'^', 3.2F, "M L 0 4.6 1.6 7 3.2 4.6"},
    {U'_', 4.4F, "M L 0 -1 4.4 -1"},
    {U'`', 1.2F, "M L 0 7.2 1.2 5.9"},
    {U'a', 3.8F, "M A 1.9 2.5 1.9 2.5 0 360 M L 3.8 5 3.8 0"},
    {U'b', 3.8F, "M L 0 7.4 0 0 M A 1.9 2.5 1.9 2.5 0 360"},
    {U'c', 3.4F, "M A 2 2.5 2 2.5 48 312"},
    {U'd', 3.8F, "M L 3.8 7.4 3.8 0 M A 1.9 2.5 1.9 2.5 0 360"},
    {U'e', 4.0F, "M L 0 2.7 4 2.7 A 2 2.5 2 2.5 4 312"},
    {U'f', 2.3F, "M A 2.1 5.9 1.2 1.5 70 180 L .9 0 M L 0 5 2.2 5"},
    {U'g', 3.8F, "M A 1.9 2.5 1.9 2.5 0 360 M L 3.8 5 3.8 -.3 A 1.95 -.3 1.85 1.9 0 -150"},
    {U'h', 3.6F, "M L 0 7.4 0 0 M A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
    {U'i', 0.3F, "M L .15 5 .15 0 M A .15 6.9 .15 .15 0 360"},
    {U'j', 1.3F, "M L 1.1 5 1.1 -.8 A -.1 -.8 1.2 1.3 0 -75 M A 1.1 6.9 .15 .15 0 360"},
    {U'k', 3.4F, "M L 0 7.4 0 0 M L 3.2 5 0 1.9 M L 1.2 3.06 3.4 0"},
    {U'l', 0.1F, "M L .05 7.4 .05 0"},
    {U'm', 5.8F, "M L 0 5 0 0 M A 1.45 3.5 1.45 1.5 180 0 L 2.9 0 M A 4.35 3.5 1.45 1.5 180 0 L 5.8 0"},
    {U'n', 3.6F, "M L 0 5 0 0 M A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
    {U'o', 4.0F, "M A 2 2.5 2 2.5 0 360"},
    {U'p', 3.8F, "M L 0 5 0 -2.2 M A 1.9 2.5 1.9 2.5 0 360"},
    {U'q', 3.8F, "M L 3.8 5 3.8 -2.2 M A 1.9 2.5 1.9 2.5 0 360"},
    {U'r', 2.2F, "M L 0 5 0 0 M A 1.8 3.1 1.8 1.9 180 75"},
    {U's', 3.3F, "M A 1.65 3.75 1.45 1.25 38 270 A 1.65 1.25 1.65 1.25 90 -148"},
    {U't', 2.2F, "M L .9 6.6 .9 1.3 A 2.1 1.3 1.2 1.3 180 275 M L 0 5 2.2 5"},
    {U'u', 3.6F, "M L 0 5 0 1.8 A 1.8 1.8 1.8 1.8 180 360 M L 3.6 5 3.6 0"},
    {U'v', 3.8F, "M L 0 5 1.9 0 3.8 5"},
    {U'w', 5.6F, "M L 0 5 1.4 0 2.8 4.6 4.2 0 5.6 5"},
    {U'x', 3.7F, "M L 0 5 3.7 0 M L 3.7 5 0 0"},
    {U'y', 3.8F, "M L 0 5 1.95 .1 M L 3.8 5 1.5 -1.3 A .7 -1.1 .8 1 -20 -100"},
    {U'z', 3.4F, "M L 0 5 3.3 5 0 0 3.4 0"},
    {U'{', 1.8F, "M A 1.8 6.5 .9 1.1 90 180 L .9 4.2 0 3.2 .9 2.2 .9 0 A 1.8 0 .9 1.1 180 270"},
    {U'|', 0.0F, "M L 0 7.6 0 -1.4"},
    {U'}', 1.8F, "M A 0 6.5 .9 1.1 90 0 L .9 4.2 1.8 3.2 .9 2.2 .9 0 A 0 0 .9 1.1 0 -90"},
    {U'~', 3.8F, "M A .95 2.8 .95 .9 180 0 A 2.85 2.8 .95 .9 180 360"},
    {U'°', 2.0F, "M A 1 6 1 1 0 360"},
    {U'±', 4.0F, "M L 0 4 4 4 M L 2 2.1 2 5.9 M L 0 .6 4 .6"},
    {U'·', 0.4F, "M A .2 3 .2 .2 0 360"},
    {U'−', 3.4F, "M L 0 3.2 3.4 3.2"},
    {U'–', 4.0F, "M L 0 2.8 4 2.8"},
    {U'×', 3.0F, "M L 0 1.5 3 4.5 M L 0 4.5 3 1.5"},
    {U'µ', 3.6F, "M L 0 5 0 -2.2 M L 0 1.8 A 1.8 1.8 1.8 1.8 180 360 M L 3.6 5 3.6 0"},
    {U'²', 2.0F, "M A 1 6.3 .95 .95 160 -30 L 0 3.8 2 3.8"},
    {U'φ', 4.6F, "M A 2.3 2.5 2.3 2.5 0 360 M L 2.3 6.4 2.3 -2.2"},
    {U'\uFFFD', 3.6F, "M L 0 0 3.6 0 3.6 7 0 7 0 0"},
};

/// Reads the drawings above; they are trusted, so there is nothing to complain about.
class Pen {
 public:
  std::vector<Polyline> draw(std::string_view path) {
    char command = 'M';
    for (left_ = path; skip_spaces();) {
      const char first = left_.front();
      if (first == 'M' || first == 'L' || first == 'A') {
        command = first;
        left_.remove_prefix(1);
        if (command == 'M') strokes_.emplace_back();
      } else if (command == 'L') {
        const float x = number();
        strokes_.back().push_back({x, number()});
      } else {
        std::array<float, 6> numbers{};
        for (float& n : numbers) n = number();
        arc(numbers);
      }
    }
    return std::move(strokes_);
  }

 private:
  bool skip_spaces() {
    while (!left_.empty() && left_.front() == ' ') left_.remove_prefix(1);
    return !left_.empty();
  }
  float number() {
    skip_spaces();
    float value = 0;
    const auto end = std::from_chars(left_.data(), left_.data() + left_.size(), value).ptr;
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return value;
  }
  void arc(const std::array<float, 6>& a) {
    const float sweep = a[5] - a[4];
    const int pieces = std::max(2, static_cast<int>(std::fabs(sweep) / 12.0F));
    for (int i = 0; i <= pieces; ++i) {
      const float angle = (a[4] + sweep * static_cast<float>(i) / static_cast<float>(pieces)) * std::numbers::pi_v<float> / 180.0F;
      strokes_.back().push_back({a[0] + a[2] * std::cos(angle), a[1] + a[3] * std::sin(angle)});
    }
  }

  std::string_view left_;
  std::vector<Polyline> strokes_;
};

struct Entry {
  char32_t character;
  Glyph glyph;
};

const std::vector<Entry>& all_glyphs() {
  static const std::vector<Entry> entries = [] {
    std::vector<Entry> made;
    for (const Drawing& drawing : kDrawings) made.push_back({drawing.character, {drawing.width, Pen().draw(drawing.path)}});
    std::sort(made.begin(), made.end(), [](const Entry& a, const Entry& b) { return a.character < b.character; });
    return made;
  }();
  return entries;
}

const Glyph* find(char32_t character) {
  const auto& all = all_glyphs();
  const auto at = std::lower_bound(all.begin(), all.end(), character, [](const Entry& e, char32_t c) { return e.character < c; });
  return at != all.end() && at->character == character ? &at->glyph : nullptr;
}

}  // namespace

const Glyph& glyph(char32_t character) {
  const Glyph* found = find(character);
  return found != nullptr ? *found : *find(U'\uFFFD');
}

bool has_glyph(char32_t character) { return find(character) != nullptr; }

std::u32string decode_utf8(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80 ? 0 : (lead & 0xE0U) == 0xC0 ? 1 : (lead & 0xF0U) == 0xE0 ? 2 : (lead & 0xF8U) == 0xF0 ? 3 : -1;
    char32_t value = more <= 0 ? lead : lead & (0x3FU >> more);
    bool good = more >= 0;
    for (int k = 0; k < more && good; ++k) {
      good = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80;
      if (good) value = (value << 6) | (static_cast<unsigned char>(text[i++]) & 0x3FU);
    }
    out.push_back(good ? value : U'\uFFFD');
  }
  return out;
}

}  // namespace isotouch::view
