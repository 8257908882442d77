#include "host/qualify/fleet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/error.h"
#include "host/files/csv_cell.h"

namespace isotouch::qualify {
namespace {

namespace fs = std::filesystem;

constexpr double kMostDeviations = 5, kNormal = 1.4826, kLeastShare = 0.2;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

Board read_board(const fs::path& file, std::vector<std::string>& keys) {
  const auto wrong = [&](const std::string& why) {
    return InputError(file.string() + ": " + why + "; name files that `isotouch qualify --json` wrote");
  };
  std::ifstream in(file, std::ios::binary);
  if (!in) throw wrong("cannot be read");
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (json.is_discarded()) throw wrong("no JSON");
  try {
    Board board;
    board.name = json.at("host").is_null() ? json.at("address") : json.at("host");
    board.date = json.at("date");
    board.verdict = json.at("verdict");
    std::vector<std::string> found;
    for (const auto& limit : json.at("limits")) {
      found.push_back(limit.at("key"));
      board.values.push_back(limit.at("value").is_null() ? std::nullopt : std::optional(limit.at("value").get<double>()));
    }
    if (found.empty()) throw wrong("it holds no limits");
    if (keys.empty()) keys = found;
    if (found != keys) throw wrong("it has other limits than the reports before it");
    return board;
  } catch (const nlohmann::json::exception&) {
    throw wrong("no report of a board");
  }
}

void mark_outliers(Fleet& fleet, std::size_t key) {
  std::vector<double> values;
  for (const Board& board : fleet.boards) {
    if (board.values[key]) values.push_back(*board.values[key]);
  }
  if (values.size() < kMinFleet) return;
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  const double limit = std::max(kMostDeviations * kNormal * median(values), kLeastShare * std::abs(middle));
  for (Board& board : fleet.boards) {
    if (board.values[key] && std::abs(*board.values[key] - middle) > limit) board.outliers.push_back(fleet.keys[key]);
  }
}

}  // namespace

bool Fleet::has_outliers() const {
  return std::ranges::any_of(boards, [](const Board& board) { return !board.outliers.empty(); });
}

Fleet read_fleet(const std::vector<fs::path>& reports) {
  Fleet fleet;
  for (const fs::path& report : reports) fleet.boards.push_back(read_board(report, fleet.keys));
  for (std::size_t key = 0; key < fleet.keys.size(); ++key) mark_outliers(fleet, key);
  return fleet;
}

std::string to_csv(const Fleet& fleet) {
  std::string csv = "board,date,verdict";
  for (const std::string& key : fleet.keys) csv += ',' + csv_cell(key);
  csv += ",outliers\n";
  for (const Board& board : fleet.boards) {
    csv += csv_cell(board.name) + ',' + csv_cell(board.date) + ',' + csv_cell(board.verdict);
    for (const std::optional<double>& value : board.values) {
      char digits[32] = "";
      if (value) std::snprintf(digits, sizeof digits, "%.6g", *value);
      csv += std::string(",") + digits;
    }
    std::string outliers;
    for (const std::string& key : board.outliers) outliers += (outliers.empty() ? "" : " ") + key;
    csv += ',' + csv_cell(outliers) + '\n';
  }
  return csv;
}

}  // namespace isotouch::qualify
