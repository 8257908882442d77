/// Many boards' reports beside each other, and which board is unlike the others.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isotouch::qualify {

/// What one report says.
struct Board {
  std::string name;  ///< the host, else the controller's address
  std::string date;
  std::string verdict;                        ///< "fit" or "not fit"
  std::vector<std::optional<double>> values;  ///< one for each of the fleet's keys; none: not measured
  std::vector<std::string> outliers;          ///< keys
};

struct Fleet {
  std::vector<std::string> keys;      ///< of the limits, with their units, as the reports bring them
  std::vector<std::string> unjudged;  ///< of these, measured on too few boards to say which is an outlier
  std::vector<Board> boards;          ///< as the reports were named
};

/// How many values it takes to say that one is unlike the others.
inline constexpr std::size_t kMinFleet = 5;

/// Reads what `isotouch qualify --json` wrote. A value is an outlier when it lies farther from the median of all boards than five times their usual
/// distance (the median of the distances, times 1.4826, which makes it a standard deviation where the values scatter normally), and than a fifth of the
/// median, and than 1e-6.
///
/// fails     InputError naming the file: no such report; a board that is there with the same date
Fleet read_fleet(const std::vector<std::filesystem::path>& files);

/// One line a board; empty cells where nothing was measured.
std::string to_csv(const Fleet& fleet);

}  // namespace isotouch::qualify
