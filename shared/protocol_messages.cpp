#include "shared/protocol_messages.h"

namespace isotouch::protocol {

namespace {

constexpr bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

}  // namespace

Text Text::of(std::string_view text) {
  Text out;
  out.size = static_cast<std::uint8_t>(std::min(text.size(), kMaxName));
  std::transform(text.begin(), text.begin() + out.size, out.characters.begin(), [](char c) { return is_control(c) ? ' ' : c; });
  return out;
}

std::span<const std::uint8_t> BodyReader::take(std::size_t bytes) {
  if (body_.size() < bytes) {
    good_ = false;
    body_ = {};
    return {};
  }
  const auto taken = body_.first(bytes);
  body_ = body_.subspan(bytes);
  return taken;
}

void BodyReader::operator()(Text& text) {
  text = {};
  std::uint8_t size = 0;
  (*this)(size);
  const auto bytes = size <= kMaxName ? take(size) : take(body_.size() + 1);
  std::copy(bytes.begin(), bytes.end(), text.characters.begin());
  text.size = static_cast<std::uint8_t>(bytes.size());
  const std::string_view view = text.view();
  good_ &= std::none_of(view.begin(), view.end(), is_control);
}

void BodyWriter::operator()(const Text& text) {
  (*this)(text.size);
  const std::string_view view = text.view();
  (*this)(std::span(reinterpret_cast<const std::uint8_t*>(view.data()), view.size()));
}

void BodyWriter::operator()(const std::span<const std::uint8_t>& rest) {
  assert(body_.size() - used_ >= rest.size());
  std::copy(rest.begin(), rest.end(), body_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ += rest.size();
}

}  // namespace isotouch::protocol
