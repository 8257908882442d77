/// The reports of many boards beside each other, and which board is unlike the others.
///
/// real time   no
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isotouch::qualify {

/// What one report says.
struct FleetBoard {
  std::string name;  ///< the host, else the controller's address; where other boards have the same one, its address and device behind it
  std::string address, device;                ///< the controller's, and the serial number of its device; empty: not known
  std::string date;                           ///< UTC, as in the report
  std::string verdict;                        ///< "fit" or "not fit"
  std::vector<std::optional<double>> values;  ///< one for each of the fleet's keys, in their order and units; none: not measured
  std::vector<std::optional<double>> limits;  ///< the same of the limits; none: the report does not have this key
  std::vector<std::string> outliers;          ///< keys of the values that are unlike those of the other boards
};

struct Fleet {
  std::vector<std::string> keys;      ///< names of the limits, which end with their units, in the order of the reports
  std::vector<std::string> unjudged;  ///< of these, measured on fewer than kMinFleet boards, so no outlier is marked
  std::vector<FleetBoard> boards;     ///< in the order of the files
};

/// The number of boards that must have measured a value before an outlier is marked.
inline constexpr std::size_t kMinFleet = 5;

/// Reads files that `isotouch qualify --json` wrote, and marks outliers. A value is an outlier if its distance from the median of all boards is larger than
/// each of these: five times the usual distance, a fifth of the median's absolute value, and 1e-6. The usual distance is the median of all distances times
/// 1.4826. For normally distributed values that is the standard deviation. Of several reports of a board the newest that has the value counts for the
/// medians and for kMinFleet; each report is judged.
///
/// fails     InputError naming the file: it cannot be read, is no such report, has no limits, has an outcome or a verdict that does not follow from the
///           figures, or repeats the host, address, device and date of another one
Fleet read_fleet(const std::vector<std::filesystem::path>& files);

/// A verdict holds for the limits of its own report. Where these differ from board to board, one sentence for each key: "inactive: at most 50 on red, at most
/// 100 on blue, missing on green".
std::vector<std::string> unlike_limits(const Fleet& fleet);

/// A CSV table with one line a board: board, date, verdict, the values by their keys, outliers, the limits by their keys. A cell is empty if nothing was
/// measured, or if the report has no such limit.
std::string to_csv(const Fleet& fleet);

}  // namespace isotouch::qualify
