#include "hil/falcon_model/quirks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace isotouch::falcon_model {

namespace {

constexpr std::array<std::pair<std::string_view, bool Quirks::*>, 10> kSwitches = {{
    {"leading-zero", &Quirks::leading_zero},
    {"stray-13", &Quirks::stray_13},
    {"stale-status", &Quirks::stale_status},
    {"mislock", &Quirks::mislock},
    {"silent-on-wrong-rate", &Quirks::silent_on_wrong_rate},
    {"firmware-loaded", &Quirks::firmware_loaded},
    {"no-wall-power", &Quirks::no_wall_power},
    {"forgets-on-unplug", &Quirks::forgets_on_unplug},
    {"homed-only-while-homing", &Quirks::homed_only_while_homing},
    {"frozen-until-homed", &Quirks::frozen_until_homed},
}};

constexpr std::array<std::pair<std::string_view, int Quirks::*>, 2> kNumbers = {{
    {"fail-handshakes", &Quirks::fail_handshakes},
    {"fail-uploads", &Quirks::fail_uploads},
}};

}  // namespace

void set_quirk(Quirks& quirks, std::string_view text) {
  for (const auto& [name, member] : kSwitches) {
    if (text == name) {
      quirks.*member = true;
      return;
    }
  }
  const std::size_t equals = std::min(text.find('='), text.size());
  for (const auto& [name, member] : kNumbers) {
    if (text.substr(0, equals) != name) continue;
    const std::string_view number = text.substr(std::min(equals + 1, text.size()));
    int value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc{} || end != number.data() + number.size() || value < 0) {
      throw std::invalid_argument("quirk '" + std::string(text) + "' needs a whole number, as in " + std::string(name) + "=2");
    }
    quirks.*member = value;
    return;
  }
  std::string known;
  for (const std::string& name : quirk_names()) known += (known.empty() ? "" : ", ") + name;
  throw std::invalid_argument("no quirk is called '" + std::string(text) + "'; there are: " + known);
}

std::vector<std::string> quirk_names() {
  std::vector<std::string> names;
  for (const auto& [name, member] : kSwitches) names.emplace_back(name);
  for (const auto& [name, member] : kNumbers) names.push_back(std::string(name) + "=N");
  return names;
}

}  // namespace isotouch::falcon_model
