/// The ticks as the page draws them: a row of 32-bit numbers for each, whatever the trace or the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "host/touch/hand_work.h"
#include "shared/tick_io.h"
#include "shared/trace.h"

namespace isotouch::server {

/// The columns of a row, in their order: floats, then whole numbers. The page finds them by these names.
inline constexpr std::array<std::string_view, 11> kFloatColumns = {"hip_x_mm",   "hip_y_mm",       "hip_z_mm",  "proxy_x_mm",
                                                                   "proxy_y_mm", "proxy_z_mm",     "force_x_n", "force_y_n",
                                                                   "force_z_n",  "penetration_mm", "energy_mj"};
inline constexpr std::array<std::string_view, 3> kWholeColumns = {"status", "state_faults", "field_generation"};
inline constexpr std::size_t kRowBytes = 4 * (kFloatColumns.size() + kWholeColumns.size());

/// Both lists, for the page.
nlohmann::ordered_json column_names();

/// Adds up what needs the ticks before.
class RowWriter {
 public:
  /// Appends the row of the next tick, little-endian.
  ///
  /// hip, proxy      NaN while nobody knows where the hand of a device is
  /// penetration_mm  length of the deflection in contact, else 0
  /// energy_mj       work that the force has done on the hand since the first row: hand_work.h
  /// state_faults    SupervisorState in the lower half, Faults in the upper one
  void append(const TraceRecord& record, std::string& rows);
  /// Ticks are missing before the next row: nobody knows what work was done in them, so none is added.
  void gap() { work_.lift(); }

  double energy_mj() const { return work_.mj(); }

 private:
  touch::HandWork work_;
};

}  // namespace isotouch::server
