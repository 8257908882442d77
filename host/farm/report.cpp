#include "host/farm/report.h"

#include <map>
#include <tuple>

#include "host/files/csv_cell.h"

namespace isotouch::farm {
namespace {

using Outcome = Answer::Outcome;

bool is(const Row& row, Outcome outcome) { return row.answer && row.answer->outcome == outcome; }

/// Answers that contradict cannot all be equal.
bool is_different(const Row& row) { return is(row, Outcome::kDiffers) || is(row, Outcome::kContradicts); }

std::string tick_text(const std::optional<std::uint64_t>& tick) { return tick ? std::to_string(*tick) : ""; }

}  // namespace

std::vector<Row> merge(const std::vector<Recording>& recordings, const std::vector<Program>& programs,
                       const std::filesystem::path& answers) {
  std::vector<Row> rows;
  rows.reserve(recordings.size() * programs.size());
  for (const Recording& recording : recordings)
    for (const Program& program : programs) rows.push_back({&recording, &program, kept_answer(answers, recording, program)});
  return rows;
}

Counts count(const std::vector<Row>& rows) {
  Counts counts;
  for (const Row& row : rows) {
    ++(!row.answer ? counts.missing : is(row, Outcome::kEqual) ? counts.equal : is_different(row) ? counts.differs : counts.failed);
  }
  return counts;
}

std::vector<Change> changes(const std::vector<Row>& rows) {
  struct History {
    const Program* equal = nullptr;
    std::size_t unknown = 0;
    std::optional<std::size_t> open;  ///< the change that goes on
  };
  std::vector<Change> all;
  std::map<std::tuple<const Recording*, std::string, std::string, std::string>, History> histories;
  for (const Row& row : rows) {
    History& history = histories[{row.recording, row.program->processor, row.program->compiler, row.program->rung}];
    if (is(row, Outcome::kEqual)) {
      if (history.open) all[*history.open].again = row.program;
      history = {row.program, 0, std::nullopt};
    } else if (!is_different(row)) {
      ++history.unknown;
    } else if (!history.open) {
      history.open = all.size();
      all.push_back({row.recording, row.program, row.answer->first_different, history.equal, history.unknown});
    }
  }
  return all;
}

std::string in_words(const Change& change) {
  const Program& since = *change.since;
  std::string words = "since " + since.commit + " on " + since.processor + " (" + since.compiler + ", rung " + since.rung + ")";
  if (change.tick) words += ", first in tick " + std::to_string(*change.tick);
  if (change.unknown > 0) {
    words += change.before != nullptr ? "; equal at " + change.before->commit + ", not known at " : "; not known at ";
    words += std::to_string(change.unknown) + (change.unknown == 1 ? " commit" : " commits") + " before";
  }
  if (change.again != nullptr) words += "; equal again at " + change.again->commit;
  return words;
}

std::vector<Speed> speeds(const std::vector<Row>& rows) {
  std::map<std::string, Speed> by_processor;
  for (const Row& row : rows) {
    if (!row.answer || row.answer->outcome == Outcome::kFailed) continue;
    Speed& speed = by_processor[row.program->processor];
    speed.processor = row.program->processor;
    speed.ticks += static_cast<double>(row.answer->ticks);
    speed.seconds += row.answer->seconds;
  }
  std::vector<Speed> all;
  all.reserve(by_processor.size());
  for (const auto& [processor, speed] : by_processor) all.push_back(speed);
  return all;
}

std::string to_csv(const std::vector<Row>& rows) {
  std::string csv = "recording,processor,commit,compiler,rung,outcome,hash,first_different\n";
  for (const Row& row : rows) {
    const Program& program = *row.program;
    for (const std::string* text : {&row.recording->name, &program.processor, &program.commit, &program.compiler, &program.rung})
      csv += csv_cell(*text) + ',';
    csv += row.answer ? std::string(name_of(row.answer->outcome)) + ',' + row.answer->hash + ',' + tick_text(row.answer->first_different)
                      : "missing,,";
    csv += '\n';
  }
  return csv;
}

}  // namespace isotouch::farm
