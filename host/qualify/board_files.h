/// Parsers for what the kernel prints about a board: whole numbers, lists of processors, scheduling of threads, /proc/interrupts. Text of another form
/// gives no value.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace isotouch::qualify {

/// A whole number and nothing else but blanks around it.
std::optional<std::int64_t> whole_number(std::string_view text);

/// "0-2,5": processors, rising. An empty text is no processor.
///
/// returns   nothing: it is no such list, or names a processor beyond 8191
std::optional<std::set<int>> processors(std::string_view text);
/// The shortest such list.
std::string list_of(const std::set<int>& processors);

/// How a thread is scheduled, of /proc/PID/stat.
struct Scheduling {
  int policy = 0;    ///< 1 = SCHED_FIFO, 2 = SCHED_RR
  int priority = 0;  ///< of these two, 1 to 99

  bool is_real_time() const { return policy == 1 || policy == 2; }
  /// As chrt names it; of a real-time one.
  std::string text() const { return (policy == 1 ? "SCHED_FIFO " : "SCHED_RR ") + std::to_string(priority); }
};
std::optional<Scheduling> scheduling(std::string_view stat);
/// Its name, of the same file; empty: it is none.
std::string name_in(std::string_view stat);

/// One row of /proc/interrupts that has a number.
struct Interrupt {
  int number = 0;
  std::vector<std::uint64_t> counts;  ///< by processor, as the header lists them
  std::string name;                   ///< of the devices that share it

  bool has_come() const;
};
std::vector<Interrupt> interrupts(std::string_view text);

/// For a terminal and a page: one line, without what moves a cursor, at most so many bytes.
std::string shown(std::string_view text, std::size_t most = 80);

}  // namespace isotouch::qualify
