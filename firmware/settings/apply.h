/// From settings as a person writes them to the integers of device, tick and session: the one place where a decimal number becomes fixed point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "firmware/falcon/falcon_session.h"
#include "firmware/lines/gpio_lines.h"
#include "firmware/loop/loop.h"
#include "firmware/loop/watchdog.h"
#include "firmware/settings/settings.h"
#include "shared/field_view.h"
#include "shared/files/refusal.h"

namespace isotouch::settings {

/// serial    of the device, for its calibration; empty: unknown
/// fails     kBadModel: values that are fine one by one make no device together
Result<DeviceModel> device_model(const Settings& settings, const std::string& serial);

/// Whether the arms of the settings stand near to those of the geometry, and the arms of each calibration near to those of the settings.
///
/// returns   which do not
Refusal refusal_of_angles(const Settings& settings);

TickSettings tick_settings(const Settings& settings);

/// returns   the tick's period, 100,000 to 4,000,000
std::uint32_t period_ns(const Settings& settings);

/// Whether this device may render a field with these settings.
///
/// measured_delay  ticks, see `loop::MeasuredDelay`; the settings' delay counts where it is larger
/// returns   why not, with what to do
Refusal refusal_of(const FieldView& field, const Settings& settings, std::uint32_t measured_delay = 0);

/// Whether this device may render anything with these settings' stiffness; 0, the field's, is judged with the field.
///
/// measured_delay  as above
/// returns   why not
Refusal refusal_of_stiffness(const Settings& settings, std::uint32_t measured_delay = 0);

/// The largest stiffness that this device may render at these settings' rate.
///
/// measured_delay  as above
Stiffness most_stiffness(const Settings& settings, std::uint32_t measured_delay = 0);

/// The largest number of thousandths that the settings can give without being above a stiffness, in N/mm.
std::string n_mm(Stiffness stiffness);

falcon::SessionSettings session_settings(const Settings& settings);

/// What each thread asks the system for, as `loop::become_realtime` takes it.
struct ThreadRights {
  int priority = 0, core = -1;
  bool operator==(const ThreadRights&) const = default;
};
struct Threads {
  ThreadRights tick, exchange, watchdog;
};
Threads thread_rights(const Settings& settings);

/// Numbers of the safety lines.
lines::GpioSettings gpio_settings(const Settings& settings);
loop::WatchdogSettings watchdog_settings(const Settings& settings);

/// Largest unpacked field.
std::size_t field_bytes(const Settings& settings);

}  // namespace isotouch::settings
