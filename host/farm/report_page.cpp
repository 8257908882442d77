#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "host/farm/report.h"
#include "host/files/html_text.h"

namespace isotouch::farm {
namespace {

constexpr const char* kHead =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>isotouch farm</title>\n"
    "<style>body{font:15px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#222;background:#fff}"
    "h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2rem}table{border-collapse:collapse}td,th{padding:.2rem .9rem .2rem 0;"
    "text-align:left;border-bottom:1px solid #ddd}td.n{text-align:right;font-variant-numeric:tabular-nums}"
    ".differs{color:#b00020;font-weight:600}.failed,.missing{color:#8a4b00}.equal{color:#17692b}</style></head><body>\n";

std::string cell(const std::string& text, const char* look = "") {
  return std::string("<td class=\"") + look + "\">" + html_text(text) + "</td>";
}

std::string head(std::initializer_list<const char*> names) {
  std::string row = "<table><tr>";
  for (const char* name : names) row += std::string("<th>") + name + "</th>";
  return row + "</tr>\n";
}

std::string in_words(const Counts& counts) {
  return std::to_string(counts.equal) + " equal, " + std::to_string(counts.differs) + " different, " + std::to_string(counts.failed) +
         " failed, " + std::to_string(counts.missing) + " missing";
}

const char* look_of(const Counts& counts) {
  return counts.differs > 0 ? "differs" : counts.failed + counts.missing > 0 ? "failed" : "equal";
}

std::string table_of_changes(const std::vector<Row>& rows) {
  const std::vector<Change> all = changes(rows);
  if (all.empty()) return "<p>No answer differs.</p>\n";
  std::string html = head({"recording", "origin", "processor", "compiler", "rung", "since commit", "first tick", "known"});
  for (const Change& change : all) {
    html += "<tr>" + cell(change.recording->name) + cell(change.recording->origin) + cell(change.since->processor) +
            cell(change.since->compiler) + cell(change.since->rung) + cell(change.since->commit) +
            cell(change.tick ? std::to_string(*change.tick) : "not named", "n") + cell(in_words(change)) + "</tr>\n";
  }
  return html + "</table>\n";
}

/// Commits downwards, processors to the right.
std::string table_of_commits(const std::vector<Row>& rows) {
  std::vector<std::string> commits, processors;
  std::map<std::pair<std::string, std::string>, std::vector<Row>> cells;
  const auto note = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Row& row : rows) {
    note(commits, row.program->commit), note(processors, row.program->processor);
    cells[{row.program->commit, row.program->processor}].push_back(row);
  }
  std::string html = "<table><tr><th>commit</th>";
  for (const std::string& processor : processors) html += "<th>" + html_text(processor) + "</th>";
  html += "</tr>\n";
  for (const std::string& commit : commits) {
    html += "<tr>" + cell(commit);
    for (const std::string& processor : processors) {
      const auto found = cells.find({commit, processor});
      const Counts counts = found == cells.end() ? Counts{} : count(found->second);
      html += counts.all() == 0 ? cell("") : cell(in_words(counts), look_of(counts));
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

/// What failed, and what has several answers.
std::string table_of_failures(const std::vector<Row>& rows) {
  std::string html;
  for (const Row& row : rows) {
    if (row.answer && !row.answer->said.empty()) {
      html += "<tr>" + cell(row.recording->name) + cell(row.program->processor) + cell(row.program->commit) +
              cell(row.answer->said, row.answer->outcome == Answer::Outcome::kFailed ? "failed" : "differs") + "</tr>\n";
    }
  }
  return html.empty() ? html
                      : "<h2>Without one answer</h2>\n" + head({"recording", "processor", "commit", "what it said"}) + html + "</table>\n";
}

std::string table_of_speeds(const std::vector<Row>& rows) {
  std::string html = "<h2>Speed</h2>\n" + head({"processor", "ticks", "seconds", "ticks a second"});
  const auto number = [](double value, const char* format) {
    char digits[32];
    std::snprintf(digits, sizeof digits, format, value);
    return cell(digits, "n");
  };
  for (const Speed& speed : speeds(rows)) {
    html += "<tr>" + cell(speed.processor) + number(speed.ticks, "%.0f") + number(speed.seconds, "%.2f") +
            (speed.seconds > 0 ? number(speed.ticks / speed.seconds, "%.0f") : cell("")) + "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

std::string to_html(const std::vector<Row>& rows) {
  return kHead + std::string("<h1>Recordings replayed</h1>\n<p>") + in_words(count(rows)) + ".</p>\n<h2>What differs, since when</h2>\n" +
         table_of_changes(rows) + "<h2>By commit and processor</h2>\n" + table_of_commits(rows) + table_of_failures(rows) +
         table_of_speeds(rows) + "</body></html>\n";
}

}  // namespace isotouch::farm
