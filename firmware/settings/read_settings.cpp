#include "firmware/settings/read_settings.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include "firmware/settings/ascii_toml.h"
#include "firmware/settings/contradiction.h"
#include "firmware/settings/table.h"

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnull-dereference"
#endif
// The library asserts of a key's first character what it then checks itself: a file must not end the program, and no compiler may take it for granted.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace isotouch::settings {

namespace {

std::string number(double value) {
  std::ostringstream text;
  text.precision(10);
  text << value;
  return text.str();
}

std::string in_quotes(std::string_view text) { return std::string("'").append(text).append("'"); }

/// Reads one value into its member; returns what it must be instead, empty when it is that.
struct Take {
  const toml::node& node;
  const Setting& setting;
  Settings& settings;

  std::string range() const {
    const std::string unit = setting.unit.empty() ? "" : std::string(" ").append(setting.unit);
    return std::string("from ").append(number(setting.low)).append(" to ").append(number(setting.high)).append(unit);
  }
  bool inside(double value) const { return value >= setting.low && value <= setting.high; }
  static std::optional<double> number_of(const toml::node& node) { return node.is_number() ? node.value<double>() : std::nullopt; }

  std::string operator()(double Settings::*member) const {
    const auto value = number_of(node);
    if (!value || !inside(*value)) return "a number " + range();
    settings.*member = *value;
    return {};
  }
  std::string operator()(std::optional<double> Settings::*member) const {
    const auto value = number_of(node);
    if (!value || !inside(*value)) return "a number " + range();
    settings.*member = *value;
    return {};
  }
  std::string operator()(int Settings::*member) const {
    const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
    if (!value || *value < static_cast<std::int64_t>(setting.low) || *value > static_cast<std::int64_t>(setting.high)) {
      return "a whole number " + range();
    }
    settings.*member = static_cast<int>(*value);
    return {};
  }
  std::string operator()(bool Settings::*member) const {
    if (!node.is_boolean()) return "true or false";
    settings.*member = *node.value<bool>();
    return {};
  }
  std::string operator()(std::string Settings::*member) const {
    if (!node.is_string()) return setting.choices.empty() ? "a text in quotes" : "one of " + std::string(setting.choices);
    const std::string value = *node.value<std::string>();
    if (!setting.choices.empty()) {
      const std::string choices = std::string("|").append(setting.choices).append("|");
      if (value.empty() || value.find('|') != std::string::npos ||
          choices.find(std::string("|").append(value).append("|")) == std::string::npos) {
        return "one of " + std::string(setting.choices);
      }
    }
    settings.*member = value;
    return {};
  }
  std::string operator()(std::array<double, 3> Settings::*member) const {
    const std::string wanted = "three numbers in brackets, each " + range();
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 3) return wanted;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = number_of(*array->get(i));
      if (!value || !inside(*value)) return wanted;
      (settings.*member)[i] = *value;
    }
    return {};
  }
};

class Reader {
 public:
  Reader(const std::string& name, Settings& settings) : name_(name), settings_(settings) {}

  Refusal read(const toml::table& file) const {
    for (const auto& [key, node] : file) {
      const std::string_view section = key.str();
      const toml::table* entries = node.as_table();
      if (section == "calibration" && entries != nullptr) {
        if (Refusal refusal = read_calibrations(*entries)) return refusal;
      } else if (entries == nullptr) {
        return at(key) + in_quotes(section) + " is outside every section; " + advice();
      } else {
        bool known = false;
        for (const Setting& setting : table()) known |= setting.section == section;
        if (!known) return at(key) + "there is no section " + in_quotes(section) + "; " + advice();
        if (Refusal refusal = read_section(section, *entries)) return refusal;
      }
    }
    return {};
  }

 private:
  static std::string advice() { return "'isotouchd --print-config' lists all settings"; }
  std::string at(const toml::key& key) const { return name_ + ":" + std::to_string(key.source().begin.line) + ": "; }

  Refusal read_section(std::string_view section, const toml::table& entries) const {
    for (const auto& [key, node] : entries) {
      const Setting* setting = find(section, key.str());
      if (setting == nullptr) {
        return at(key) + "there is no setting " + in_quotes(key.str()) + " in section " + in_quotes(section) + "; " + advice();
      }
      const std::string wanted = std::visit(Take{node, *setting, settings_}, setting->member);
      if (!wanted.empty()) return at(key) + std::string(section) + "." + std::string(key.str()) + " must be " + wanted;
    }
    return {};
  }

  Refusal read_calibrations(const toml::table& serials) const {
    for (const auto& [serial, node] : serials) {
      const toml::table* entries = node.as_table();
      if (entries == nullptr) return at(serial) + "a calibration needs a section of its own, [calibration.SERIAL]";
      Calibration calibration;
      for (const auto& [key, value] : *entries) {
        if (key.str() != "angle_at_zero_deg") {
          return at(key) + "there is no setting " + in_quotes(key.str()) + " in a calibration; it may hold angle_at_zero_deg";
        }
        static constexpr Setting kAngles{
            "calibration", "angle_at_zero_deg", &Settings::workspace_origin_mm, "degrees", -180, 180, {}, {}, {}};
        Settings place;
        const std::string wanted = Take{value, kAngles, place}(&Settings::workspace_origin_mm);
        if (!wanted.empty()) return at(key) + "angle_at_zero_deg must be " + wanted;
        calibration.angle_at_zero_deg = place.workspace_origin_mm;
      }
      if (entries->empty())
        return at(serial) + "the calibration of " + in_quotes(serial.str()) + " is empty; give it angle_at_zero_deg or leave it out";
      settings_.calibrations[std::string(serial.str())] = calibration;
    }
    return {};
  }

  const std::string& name_;
  Settings& settings_;
};

/// What stands behind the first `=` of a line, without comment; empty: nothing.
std::string_view value_in(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  line = line.substr(equals + 1);
  line = line.substr(0, line.find('#'));
  const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : line.substr(first, last - first + 1);
}

/// Most of what is not TOML is a text without quotes: of that the library knows only that it is no value.
std::string explain(const toml::parse_error& error, std::string_view file) {
  for (toml::source_index line = 1; line < error.source().begin.line; ++line) file.remove_prefix(file.find('\n') + 1);
  const std::string_view value = value_in(file.substr(0, file.find('\n')));
  const bool is_plain = !value.empty() && value.find_first_of("\"'[]{}") == std::string_view::npos;
  if (is_plain && !toml::parse(std::string("value = ").append(value)))
    return in_quotes(value) + " is no value; write a number, true or false, or a text in quotes";
  return "this is not TOML: " + std::string(error.description());
}

}  // namespace

Refusal parse_settings(std::string_view text, const std::string& name, Settings& settings) {
  const AsciiToml ascii = ascii_toml(text);
  if (ascii.stray_line != 0) {
    return name + ":" + std::to_string(ascii.stray_line) +
           ": there is a character that is not ASCII outside a comment; in a string write it as \\u and four hexadecimal digits";
  }
  const toml::parse_result result = toml::parse(ascii.text, name);
  if (!result) {
    const toml::parse_error& error = result.error();
    return name + ":" + std::to_string(error.source().begin.line) + ": " + explain(error, ascii.text);
  }
  if (Refusal refusal = Reader(name, settings).read(result.table())) return refusal;
  if (const Refusal refusal = refusal_of_contradiction(settings)) return name + ": " + refusal.sentence();
  return {};
}

Refusal read_settings(const std::string& path, Settings& settings) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file.good() && !file.eof()) return path + ": it cannot be read; give the name of a settings file";
  return parse_settings(text, path, settings);
}

}  // namespace isotouch::settings
