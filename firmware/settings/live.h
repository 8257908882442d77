/// Settings that a person changes while they are felt: asked for by name, checked as in the file, given to the tick.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include "firmware/loop/requests.h"
#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"

namespace isotouch::settings {

class LiveSettings {
 public:
  explicit LiveSettings(const Settings& begin) : now_(begin) {}

  /// Those that hold now; any thread.
  Settings now() const;

  /// Changes one of section [feel], from the next tick on. Any thread.
  ///
  /// name      of the setting, with or without "feel."
  /// value     a number as in the file
  /// requests  take it to the tick
  /// measured_delay  ticks, see `loop::measured_delay_ticks`
  /// returns   why it is not set
  Refusal set(std::string_view name, std::string_view value, loop::Requests& requests, std::uint32_t measured_delay = 0);

  /// Lowers a stiffness of the settings to what the loop holds with the delay that was measured, from the next tick on. Any thread.
  ///
  /// returns   one sentence that says so; empty where nothing had to change
  std::string keep_within(loop::Requests& requests, std::uint32_t measured_delay);

 private:
  void change_to(const Settings& changed, loop::Requests& requests);

  mutable std::mutex mutex_;
  Settings now_;
};

}  // namespace isotouch::settings
