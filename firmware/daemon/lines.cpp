#include "firmware/daemon/lines.h"

#include <cerrno>
#include <cstring>

#include "firmware/settings/apply.h"

namespace isotouch::daemon {

namespace {

std::string why_not_opened(int error) {
  if (error == EACCES || error == EPERM)
    return "may not be opened by this user; add the user to the group gpio, and install 60-isotouch-gpio.rules, which gives it the chips";
  return std::string(std::strerror(error)) + "; name a chip that 'gpiodetect' shows";
}

}  // namespace

Refusal take_lines(const settings::Settings& settings, loop::Clock& clock, const loop::TickStats& stats, Lines& lines, OpenGpio open) {
  if (settings.line_chip.empty()) return {};
  lines.chip = open(settings.line_chip);
  if (!lines.chip) return "lines.chip = " + settings.line_chip + ": " + why_not_opened(errno);
  if (Refusal refusal = lines.wires.emplace(*lines.chip, clock).take(settings::gpio_settings(settings))) return refusal;
  lines.watchdog.emplace(settings::watchdog_settings(settings), *lines.wires, clock, lines.state, stats.ticks);
  lines.state.set_patience(static_cast<std::uint32_t>(settings.tick_hz / 10));  // 100 ms: the watchdog looks every millisecond
  return {};
}

}  // namespace isotouch::daemon
