/// One loop on all processors. Results go to places of their own, so the answer does not depend on how many there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace isotouch::field {

/// How many threads a loop uses. It holds for the loops that this thread begins as long as the limit lives, and for loops within them; then the limit before
/// holds again. Another thread that does a part of the work needs a limit of its own.
class ThreadLimit {
 public:
  /// threads   0 = as many as there are processors
  explicit ThreadLimit(unsigned threads) : before_(std::exchange(wanted_, threads)) {}
  ~ThreadLimit() { wanted_ = before_; }
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  static unsigned threads() { return wanted_ != 0 ? wanted_ : std::max(1U, std::thread::hardware_concurrency()); }

 private:
  static inline thread_local unsigned wanted_ = 0;
  unsigned before_;
};

/// Calls work(begin, end) for ranges that together are [0, count), from several threads at once.
///
/// work      must not touch what another range touches
/// grain     items a range: enough to outweigh its administration
/// fails     with what a call threw; the ranges that had not begun then are left out. Where the system gives fewer threads, those that there are do all
template <class Work>
void in_parallel(std::size_t count, std::size_t grain, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr reason;
  const auto run = [&] {
    for (std::size_t begin; !failed && (begin = next.fetch_add(grain)) < count;) {
      try {
        work(begin, std::min(begin + grain, count));
      } catch (...) {
        if (!failed.exchange(true)) reason = std::current_exception();
      }
    }
  };
  const std::size_t ranges = (count + grain - 1) / grain;
  std::vector<std::jthread> helpers;
  const unsigned threads = ThreadLimit::threads();
  for (std::size_t t = 1; t < std::min<std::size_t>(threads, ranges); ++t) {
    try {
      helpers.emplace_back([&] {
        const ThreadLimit same(threads);
        run();
      });
    } catch (const std::system_error&) {
      break;
    }
  }
  run();
  helpers.clear();  // joins
  if (reason) std::rethrow_exception(reason);
}

}  // namespace isotouch::field
