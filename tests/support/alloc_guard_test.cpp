#include "tests/support/alloc_guard.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace isotouch::test {
namespace {

/// Keeps the compiler from removing an allocation that nobody reads.
template <class T>
void use(T* pointer) {
  asm volatile("" : : "g"(pointer) : "memory");
}

TEST(AllocGuard, CountsEveryKindOfAllocation) {
  const AllocGuard guard;
  use(std::make_unique<int>(1).get());
  EXPECT_EQ(guard.count(), 1U);
  use(std::vector<int>(1000).data());
  EXPECT_EQ(guard.count(), 2U);
  struct alignas(128) Wide {
    int value;
  };
  use(std::make_unique<Wide>().get());
  EXPECT_EQ(guard.count(), 3U);
  void* block = std::malloc(8);
  use(block);
  EXPECT_EQ(guard.count(), 4U);
  block = std::realloc(block, 100'000);
  use(block);
  EXPECT_GE(guard.count(), 5U);
  std::free(block);
}

TEST(AllocGuard, CountsOtherThreads) {
  const AllocGuard guard;
  std::thread([] { use(std::make_unique<int>(1).get()); }).join();
  EXPECT_GE(guard.count(), 1U);
}

TEST(AllocGuard, ArithmeticAllocatesNothing) {
  const AllocGuard guard;
  int sum = 0;
  for (int i = 0; i < 1000; ++i) sum += i;
  use(&sum);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace isotouch::test
