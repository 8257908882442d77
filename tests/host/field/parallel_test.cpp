#include "host/field/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "tests/support/no_more_threads.h"

namespace isotouch::field {
namespace {

/// Of a loop in which each range waits until so many threads are at work, or a second.
std::size_t threads_that_met(std::size_t expected) {
  std::mutex mutex;
  std::set<std::thread::id> met;
  in_parallel(64, 1, [&](std::size_t, std::size_t) {
    for (int wait = 0; wait < 1000; ++wait) {
      {
        const std::scoped_lock lock(mutex);
        met.insert(std::this_thread::get_id());
        if (met.size() >= expected) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  return met.size();
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const unsigned before = ThreadLimit::threads();
  {
    const ThreadLimit three(3);
    EXPECT_EQ(threads_that_met(3), 3U);
    {
      const ThreadLimit one(1);
      EXPECT_EQ(threads_that_met(1), 1U);
    }
    EXPECT_EQ(ThreadLimit::threads(), 3U);
  }
  EXPECT_EQ(ThreadLimit::threads(), before);
}

TEST(ThreadLimit, IsThatOfItsThreadAndOfTheLoopsWithin) {
  const ThreadLimit three(3);
  unsigned other = 3;
  std::thread([&] { other = ThreadLimit::threads(); }).join();
  EXPECT_EQ(other, std::max(1U, std::thread::hardware_concurrency()));
  std::atomic<unsigned> within{0};
  in_parallel(64, 1, [&](std::size_t, std::size_t) { within |= 1U << ThreadLimit::threads(); });
  EXPECT_EQ(within, 1U << 3);
}

TEST(InParallel, CoversEveryItemOnce) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    const ThreadLimit limit(threads);
    std::vector<int> seen(1001, 0);
    in_parallel(seen.size(), 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++seen[i];
    });
    EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0), 1001);
    EXPECT_EQ(*std::max_element(seen.begin(), seen.end()), 1);
  }
}

TEST(InParallel, GoesOnWithTheThreadsThatItGets) {
  const test::NoMoreThreads none;
  const ThreadLimit limit(4);
  std::vector<int> seen(1001, 0);
  in_parallel(seen.size(), 10, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++seen[i];
  });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 1001);
}

TEST(InParallel, FailsWithWhatACallThrew) {
  const ThreadLimit limit(2);
  EXPECT_THROW(in_parallel(100, 1,
                           [](std::size_t begin, std::size_t) {
                             if (begin == 50) throw std::runtime_error("the fiftieth");
                           }),
               std::runtime_error);
}

}  // namespace
}  // namespace isotouch::field
