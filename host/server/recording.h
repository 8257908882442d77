/// A recorded run as the page plays it: rows of ticks, coarse curves of any part of it, and the ticks where something happened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/trace/trace_file.h"
#include "shared/field_view.h"

namespace isotouch::server {

/// Something that a person looks for in a recording.
struct Event {
  std::uint64_t tick = 0;
  std::string_view kind;  ///< "contact", "fault", "state", "setting", "field", "patch", "stop" or "resume"
  std::string text;       ///< a sentence, without a full stop
};

class Recording {
 public:
  /// field     nullptr: the outputs must be in the trace
  /// fails     InputError: there are none, and none can be computed
  Recording(const trace::Trace& trace, const FieldView* field);

  std::size_t ticks() const;
  /// Name, ticks, period, the hash of the field that it names (empty: none, or any), events, whether the field was patched meanwhile, and whether the file
  /// ends before it should.
  nlohmann::ordered_json summary() const;
  /// Rows of `tick_rows.h`; fewer where the recording ends.
  std::string rows(std::size_t from, std::size_t count) const;
  /// What one tick says to a person; of the last one where there is no such tick.
  nlohmann::ordered_json words(std::size_t tick) const;
  /// The part from a tick to another in at most so many pieces of equal length: for each the largest force, the deepest penetration, the last energy
  /// (floats), and the status bits of all its ticks (whole number), 16 bytes. Before them, 12 bytes: first tick, ticks of a piece, pieces.
  std::string curves(std::size_t from, std::size_t to, std::size_t pieces) const;

 private:
  std::string name_;
  std::string field_;
  std::uint32_t period_ns_ = 0;
  bool of_device_ = false, is_cut_off_ = false, is_patched_ = false;
  std::string rows_;
  std::vector<Event> events_;
  bool more_events_ = false;
};

/// The events of a run, tick by tick.
class EventFinder {
 public:
  static constexpr std::size_t kMaxOfAKind = 2000;  ///< that are kept: many contacts hide no fault

  void look_at(std::uint64_t tick, const TraceRecord& record);
  std::vector<Event> take() { return std::move(events_); }
  bool found_more() const { return more_; }
  bool found_patch() const { return last_patch_.has_value(); }

 private:
  void add(std::uint64_t tick, std::string_view kind, std::string text);

  std::vector<Event> events_;
  std::map<std::string_view, std::size_t> counts_;  ///< by kind
  bool more_ = false, began_ = false;
  std::uint64_t last_contact_ = 0;
  bool touched_ = false;
  Output last_;
  std::uint32_t generation_ = 0;
  std::optional<std::uint64_t> last_patch_;
};

}  // namespace isotouch::server
