/// What devices in the field were seen to do beside the rule, and what public sources disagree on: each is off until asked for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isotouch::falcon_model {

struct Quirks {
  bool leading_zero = false;             ///< a 00 before the answer to the handshake
  bool stray_13 = false;                 ///< a 13 before the first echo of an upload
  bool stale_status = false;             ///< the first read after every control request finds a status pair that fell due before
  int fail_handshakes = 0;               ///< so many handshakes stay without answer
  int fail_uploads = 0;                  ///< so many uploads are echoed wrongly from byte 100 on, and do not start
  bool mislock = false;                  ///< a cold boot loader takes an 'A' at any rate for the upload's
  bool silent_on_wrong_rate = false;     ///< nothing instead of garbage with framing errors
  bool firmware_loaded = false;          ///< runs from the start
  bool no_wall_power = false;            ///< the chip lives on USB, nobody answers behind it
  bool forgets_on_unplug = false;        ///< firmware does not outlive the USB cable
  bool homed_only_while_homing = false;  ///< the homed bits are shown only while the homing flag is set
  bool frozen_until_homed = false;       ///< an axis reports no movement before it is homed
};

/// Sets one quirk by name, as "leading-zero" or "fail-uploads=2".
///
/// fails     std::invalid_argument: an unknown name, or a number that is missing or not one
void set_quirk(Quirks& quirks, std::string_view text);

std::vector<std::string> quirk_names();

}  // namespace isotouch::falcon_model
