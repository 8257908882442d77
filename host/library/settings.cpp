#include "host/library/settings.h"

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "host/library/call.h"
#include "host/to_double.h"
#include "shared/device_model.h"
#include "shared/tick_settings.h"
#include "shared/tick_times.h"

namespace isotouch::library {

namespace {

struct Member {
  const char* name;
  double isotouch_settings::*at;
};

/// In the order of kTickSettingRows.
constexpr std::array<Member, kTickSettings> kMembers = {{{"stiffness", &isotouch_settings::stiffness},
                                                         {"damping", &isotouch_settings::damping},
                                                         {"force_limit_n", &isotouch_settings::force_limit_n},
                                                         {"friction", &isotouch_settings::friction},
                                                         {"friction_damping", &isotouch_settings::friction_damping},
                                                         {"hand_damping", &isotouch_settings::hand_damping},
                                                         {"passivity_damping", &isotouch_settings::passivity_damping},
                                                         {"weight_n", &isotouch_settings::weight_n},
                                                         {"ramp_ticks", &isotouch_settings::ramp_ticks},
                                                         {"device_damping", &isotouch_settings::device_damping},
                                                         {"delay_ticks", &isotouch_settings::delay_ticks}}};

/// fails     CallError naming the member: outside the row's range, or a part of a tick
std::int32_t raw_of(const char* name, const SettingRow& row, double value) {
  const bool in_range = (value >= row.low && value <= row.high) || (row.zero_means_unset && value == 0);
  const bool whole = row.fraction_bits > 0 || value == std::floor(value);
  if (in_range && whole) return row.raw(value);  // false for NaN, too
  std::ostringstream sentence;
  sentence << name << " is " << value << (row.unit.empty() ? "" : " ") << row.unit << " and must be from " << row.low << " to " << row.high
           << (row.fraction_bits > 0 ? "" : ", a whole number") << (row.zero_means_unset ? ", or 0 for unset" : "")
           << "; choose another value";
  refuse(ISOTOUCH_BAD_ARGUMENT, sentence.str());
}

}  // namespace

isotouch_settings default_settings() {
  isotouch_settings settings{};
  settings.period_ns = static_cast<std::uint32_t>(rows::kPeriod.standard);
  settings.device = ISOTOUCH_LIBNIFALCON;
  settings.play_mm = rows::kPlay.standard;
  for (std::size_t i = 0; i < kTickSettings; ++i) settings.*kMembers[i].at = kTickSettingRows[i]->standard;
  return settings;
}

TraceHeader header_of(const isotouch_settings& settings) {
  if (settings.device > ISOTOUCH_MARTIN_HILLIER)
    refuse(ISOTOUCH_BAD_ARGUMENT, "device is " + std::to_string(settings.device) + ", which is no isotouch_device; choose 0 or 1");
  TraceHeader header;
  header.has_outputs = true;
  header.period_ns = static_cast<std::uint32_t>(raw_of("period_ns", rows::kPeriod, settings.period_ns));
  header.device = at_period(settings.device == ISOTOUCH_LIBNIFALCON ? libnifalcon_model() : martin_hillier_model(), header.period_ns);
  header.device.play = Mm::from_raw(raw_of("play_mm", rows::kPlay, settings.play_mm));
  RawSettings raw{};
  for (std::size_t i = 0; i < kTickSettings; ++i) raw[i] = raw_of(kMembers[i].name, *kTickSettingRows[i], settings.*kMembers[i].at);
  header.settings = from_raw(raw);
  return header;
}

}  // namespace isotouch::library

isotouch_status isotouch_settings_default(isotouch_settings* settings, size_t size) {
  using namespace isotouch::library;
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(settings, "settings", size, "isotouch_settings");
    *settings = default_settings();
  });
}
