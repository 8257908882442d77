#include "host/qualify/fleet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "host/error.h"
#include "host/files/csv_cell.h"
#include "host/files/whole_file.h"
#include "host/qualify/verdict.h"
#include "host/quantiles.h"
#include "shared/printable.h"

namespace isotouch::qualify {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxDeviations = 5, kNormal = 1.4826, kLeastShare = 0.2, kLeast = 1e-6;

/// What a report says of one board, by the keys of its limits.
struct Report {
  FleetBoard board;
  std::vector<std::pair<std::string, std::optional<double>>> values;
};

std::string text_in(const nlohmann::json& json) {
  std::string text = json;
  make_printable(text, ' ');
  return text;
}

std::optional<double> value_in(const nlohmann::json& json) { return json.is_null() ? std::nullopt : std::optional(json.get<double>()); }

Report read_report(const fs::path& file) {
  const auto wrong = [&](const std::string& why) {
    return InputError(file.string() + ": " + why + "; name files that `isotouch qualify --json` wrote");
  };
  const auto bytes = read_file(file);
  const nlohmann::json json = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (json.is_discarded()) throw wrong("no JSON");
  Report report;
  std::vector<Judgement> judgements;
  try {
    report.board.name = text_in(json.at("host").is_null() ? json.at("address") : json.at("host"));
    report.board.date = text_in(json.at("date"));
    report.board.verdict = text_in(json.at("verdict"));
    for (const auto& limit : json.at("limits")) {
      const auto& [key, value] = report.values.emplace_back(text_in(limit.at("key")), value_in(limit.at("value")));
      judgements.push_back(judged(key, "", "", limit.at("limit").get<double>(), value));
      const std::string outcome = text_in(limit.at("outcome"));
      if (outcome != name_of(judgements.back().outcome))
        throw wrong("the outcome '" + outcome + "' of " + key + " does not follow from its value and limit");
    }
  } catch (const nlohmann::json::exception&) {
    throw wrong("no report of a board");
  }
  if (judgements.empty()) throw wrong("a report without limits");
  if (report.board.verdict != verdict(judgements))
    throw wrong("the verdict '" + report.board.verdict + "' does not follow from its limits");
  return report;
}

void mark_outliers(Fleet& fleet, std::size_t key) {
  std::vector<double> values;
  for (const FleetBoard& board : fleet.boards) {
    if (board.values[key]) values.push_back(*board.values[key]);
  }
  if (values.size() < kMinFleet) {
    if (!values.empty()) fleet.unjudged.push_back(fleet.keys[key]);
    return;
  }
  const double middle = quantiles(values).median;
  for (double& value : values) value = std::abs(value - middle);
  const double limit = std::max(kMaxDeviations * kNormal * quantiles(values).median, std::max(kLeastShare * std::abs(middle), kLeast));
  for (FleetBoard& board : fleet.boards) {
    if (board.values[key] && std::abs(*board.values[key] - middle) > limit) board.outliers.push_back(fleet.keys[key]);
  }
}

}  // namespace

Fleet read_fleet(const std::vector<fs::path>& files) {
  Fleet fleet;
  for (const fs::path& file : files) {
    Report report = read_report(file);
    const auto same = [&](const FleetBoard& board) { return board.name == report.board.name && board.date == report.board.date; };
    if (std::ranges::any_of(fleet.boards, same))
      throw InputError(file.string() + ": " + report.board.name + " is there with the same date; name each report once");
    for (const auto& [key, value] : report.values) {
      const auto at = static_cast<std::size_t>(std::ranges::find(fleet.keys, key) - fleet.keys.begin());
      if (at == fleet.keys.size()) fleet.keys.push_back(key);
      report.board.values.resize(std::max(report.board.values.size(), at + 1));
      report.board.values[at] = value;
    }
    fleet.boards.push_back(std::move(report.board));
  }
  for (FleetBoard& board : fleet.boards) board.values.resize(fleet.keys.size());
  for (std::size_t key = 0; key < fleet.keys.size(); ++key) mark_outliers(fleet, key);
  return fleet;
}

std::string to_csv(const Fleet& fleet) {
  std::string csv = "board,date,verdict";
  for (const std::string& key : fleet.keys) csv += ',' + csv_cell(key);
  csv += ",outliers\n";
  for (const FleetBoard& board : fleet.boards) {
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
