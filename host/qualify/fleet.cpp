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
  std::vector<std::string> keys;
  std::vector<std::optional<double>> values, limits;
};

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

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
    for (const auto& [key, text] : {std::pair("address", &report.board.address), std::pair("device", &report.board.device)}) {
      if (const auto found = json.find(key); found != json.end() && !found->is_null()) *text = text_in(*found);
    }
    report.board.date = text_in(json.at("date"));
    report.board.verdict = text_in(json.at("verdict"));
    for (const auto& limit : json.at("limits")) {
      const std::string& key = report.keys.emplace_back(text_in(limit.at("key")));
      report.values.push_back(value_in(limit.at("value")));
      report.limits.emplace_back(limit.at("limit").get<double>());
      judgements.push_back(judged(key, "", "", *report.limits.back(), report.values.back()));
      judgements.back().is_lost = key == "celsius_max" && !report.values.back() && json.contains("sensors_unknown");
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

/// What stands beside the keys of one report, in the order of all keys.
std::vector<std::optional<double>> by_keys(const std::vector<std::string>& all, const std::vector<std::string>& keys,
                                           const std::vector<std::optional<double>>& numbers) {
  std::vector<std::optional<double>> ordered(all.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    ordered[static_cast<std::size_t>(std::ranges::find(all, keys[i]) - all.begin())] = numbers[i];
  return ordered;
}

bool is_same_board(const FleetBoard& a, const FleetBoard& b) { return a.name == b.name && a.address == b.address && a.device == b.device; }

/// One value for each board that has measured it: the newest.
std::vector<double> values_of_boards(const std::vector<FleetBoard>& reports, std::size_t key) {
  std::vector<double> values;
  for (const FleetBoard& report : reports) {
    const auto replaces = [&](const FleetBoard& later) {
      return later.values[key] && is_same_board(later, report) && later.date > report.date;
    };
    if (report.values[key] && std::ranges::none_of(reports, replaces)) values.push_back(*report.values[key]);
  }
  return values;
}

void mark_outliers(Fleet& fleet, std::size_t key) {
  std::vector<double> values = values_of_boards(fleet.boards, key);
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

/// The name of a host that several boards have does not say which is meant.
void tell_apart(std::vector<FleetBoard>& boards) {
  std::vector<bool> is_shared;
  for (const FleetBoard& board : boards)
    is_shared.push_back(std::ranges::any_of(boards, [&](const FleetBoard& b) { return b.name == board.name && !is_same_board(b, board); }));
  for (std::size_t i = 0; i < boards.size(); ++i) {
    if (is_shared[i]) boards[i].name += " (" + boards[i].address + (boards[i].device.empty() ? "" : ", " + boards[i].device) + ")";
  }
}

}  // namespace

Fleet read_fleet(const std::vector<fs::path>& files) {
  Fleet fleet;
  std::vector<Report> reports;
  for (const fs::path& file : files) {
    Report report = read_report(file);
    const auto same = [&](const FleetBoard& board) { return is_same_board(board, report.board) && board.date == report.board.date; };
    if (std::ranges::any_of(fleet.boards, same))
      throw InputError(file.string() + ": " + report.board.name + " is there with the same date; name each report once");
    for (const std::string& key : report.keys) {
      if (std::ranges::find(fleet.keys, key) == fleet.keys.end()) fleet.keys.push_back(key);
    }
    reports.push_back(std::move(report));
    fleet.boards.push_back(reports.back().board);
  }
  tell_apart(fleet.boards);
  for (std::size_t board = 0; board < reports.size(); ++board) {
    fleet.boards[board].values = by_keys(fleet.keys, reports[board].keys, reports[board].values);
    fleet.boards[board].limits = by_keys(fleet.keys, reports[board].keys, reports[board].limits);
  }
  for (std::size_t key = 0; key < fleet.keys.size(); ++key) mark_outliers(fleet, key);
  return fleet;
}

std::vector<std::string> unlike_limits(const Fleet& fleet) {
  std::vector<std::string> sentences;
  for (std::size_t key = 0; key < fleet.keys.size(); ++key) {
    std::vector<std::pair<std::optional<double>, std::string>> limits;  // each with the boards that have it
    for (const FleetBoard& board : fleet.boards) {
      const auto found = std::ranges::find(limits, board.limits[key], [](const auto& limit) { return limit.first; });
      if (found == limits.end()) {
        limits.emplace_back(board.limits[key], board.name);
      } else {
        found->second += " and " + board.name;
      }
    }
    if (limits.size() == 1) continue;
    std::string sentence = fleet.keys[key];
    for (const auto& [limit, boards] : limits)
      sentence += (&boards == &limits.front().second ? ": " : ", ") + (limit ? "at most " + digits(*limit) : "missing") + " on " + boards;
    sentences.push_back(sentence);
  }
  return sentences;
}

std::string to_csv(const Fleet& fleet) {
  std::string csv = "board,date,verdict";
  const auto add = [&](const std::optional<double>& number) { csv += ',' + (number ? digits(*number) : ""); };
  for (const std::string& key : fleet.keys) csv += ',' + csv_cell(key);
  csv += ",outliers";
  for (const std::string& key : fleet.keys) csv += ',' + csv_cell(key + "_limit");
  csv += '\n';
  for (const FleetBoard& board : fleet.boards) {
    csv += csv_cell(board.name) + ',' + csv_cell(board.date) + ',' + csv_cell(board.verdict);
    std::ranges::for_each(board.values, add);
    std::string outliers;
    for (const std::string& key : board.outliers) outliers += (outliers.empty() ? "" : " ") + key;
    csv += ',' + csv_cell(outliers);
    std::ranges::for_each(board.limits, add);
    csv += '\n';
  }
  return csv;
}

}  // namespace isotouch::qualify
