#include "firmware/settings/contradiction.h"

#include <array>
#include <string>

namespace isotouch::settings {

namespace {

struct Line {
  const char* name;
  int Settings::*number;
};

constexpr std::array<Line, 5> kLines = {{{"stop", &Settings::line_stop},
                                         {"enable", &Settings::line_enable},
                                         {"enable_back", &Settings::line_enable_back},
                                         {"heartbeat", &Settings::line_heartbeat},
                                         {"light", &Settings::line_light}}};

Refusal refusal_of_lines(const Settings& settings) {
  for (std::size_t i = 0; i < kLines.size(); ++i) {
    const int number = settings.*kLines[i].number;
    if (number < 0) continue;
    const std::string name = std::string("lines.") + kLines[i].name;
    if (settings.line_chip.empty()) return name + " needs a GPIO chip; name it in lines.chip, or leave the line out";
    for (std::size_t other = 0; other < i; ++other) {
      if (settings.*kLines[other].number == number)
        return name + " and lines." + kLines[other].name + " are both line " + std::to_string(number) + "; give each a line of its own";
    }
  }
  const bool has_all =
      settings.line_stop >= 0 && settings.line_enable >= 0 && settings.line_enable_back >= 0 && settings.line_heartbeat >= 0;
  if (settings.lines_required && !has_all)
    return "lines.required is true, so [lines] must name chip, stop, enable, enable_back and heartbeat; name them, or set required = false";
  return {};
}

/// The watchdog goes before the tick, and the tick before the thread that talks to the device.
Refusal refusal_of_priorities(const Settings& settings) {
  if (settings.exchange_priority > 0 && settings.exchange_priority >= settings.priority)
    return "loop.exchange_priority must be below loop.priority, or 0; else the thread that talks to the device delays the tick";
  if (!settings.line_chip.empty() && settings.priority > 0 && settings.watchdog_priority <= settings.priority)
    return "lines.priority must be above loop.priority; else a tick that hangs may stop the watchdog, too";
  return {};
}

}  // namespace

Refusal refusal_of_contradiction(const Settings& settings) {
  if (settings.word_slew < settings.tick_hz)
    return "limits.word_slew must be at least loop.tick_hz (one unit a tick); with less, motor commands could rise but not fall";
  if (settings.led_active == settings.led_idle || settings.led_active == settings.led_homing)
    return "device.led_active must differ from led_idle and led_homing; else neither a person nor the guard sees whether there may be "
           "force";
  if (settings.hold_to_run && settings.button_mask == 0)
    return "buttons.hold_to_run is true, but buttons.mask = 0 lets no button count; give the mask a button";
  if (Refusal refusal = refusal_of_priorities(settings)) return refusal;
  return refusal_of_lines(settings);
}

}  // namespace isotouch::settings
