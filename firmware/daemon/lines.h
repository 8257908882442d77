/// The wires beside the device, and who watches the ticks through them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "firmware/lines/gpio_lines.h"
#include "firmware/loop/line_state.h"
#include "firmware/loop/tick_stats.h"
#include "firmware/loop/watchdog.h"
#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"

namespace isotouch::daemon {

struct Lines {
  std::unique_ptr<lines::Gpio> chip;
  std::optional<lines::GpioLines> wires;
  loop::LineState state;                   ///< what the watchdog tells the ticks
  std::optional<loop::Watchdog> watchdog;  ///< nothing where the settings name no chip
};

using OpenGpio = std::unique_ptr<lines::Gpio> (*)(const std::string& chip);

/// Takes the lines that the settings name.
///
/// clock, stats  live as long as `lines`
/// open          gives the chip, as `lines::open_gpio`
/// returns       none, too, where the settings name no chip
Refusal take_lines(const settings::Settings& settings, loop::Clock& clock, const loop::TickStats& stats, Lines& lines,
                   OpenGpio open = &lines::open_gpio);

}  // namespace isotouch::daemon
