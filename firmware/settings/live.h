/// Settings that a person changes while they are felt: asked for by name, checked as in the file, given to the tick.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/loop/requests.h"
#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"
#include "shared/tick_io.h"

namespace isotouch::settings {

/// Who sets something, and how far they may go.
struct Setter {
  std::uint32_t author = kNobody;
  bool may_raise = true;  ///< false: a force is at most as large as with the settings that the controller was started with
  Stiffness fields{};     ///< the stiffness of the field itself: the limit of the stiffness where the settings name none
};

class LiveSettings {
 public:
  explicit LiveSettings(const Settings& begin) : begin_(begin), now_(begin) {}

  /// Those that hold now; any thread.
  Settings now() const;

  /// Changes one of section [feel], from the next tick on. Any thread.
  ///
  /// name      of the setting, with or without "feel."
  /// value     a number as in the file
  /// requests  take it to the tick
  /// measured_delay  ticks, see `loop::MeasuredDelay`
  /// returns   why it is not set
  Refusal set(std::string_view name, std::string_view value, loop::Requests& requests, std::uint32_t measured_delay = 0,
              const Setter& setter = {});

  /// Lowers a stiffness of the settings to what the loop holds with the delay that was measured, from the next tick on. Any thread.
  ///
  /// returns   one sentence that says so; empty where nothing had to change
  std::string keep_within(loop::Requests& requests, std::uint32_t measured_delay);

  /// A field is felt. A stiffness that somebody set who may not raise it, and that is above this field's own, falls to it, from the next tick on.
  /// Any thread.
  ///
  /// fields    the stiffness of that field itself
  /// returns   one sentence that says so; empty where nothing had to change
  std::string keep_within_field(loop::Requests& requests, Stiffness fields);

 private:
  void change_to(const Settings& changed, loop::Requests& requests, std::uint32_t author);
  std::optional<double> limit_of(TickSetting setting, Stiffness fields) const;

  const Settings begin_;
  mutable std::mutex mutex_;
  Settings now_;
  bool is_fields_limit_ = false;  ///< the stiffness was set within the limit of a field
};

}  // namespace isotouch::settings
