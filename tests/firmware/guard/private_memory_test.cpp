#include "firmware/guard/private_memory.h"

#include <gtest/gtest.h>

#include <array>

namespace isotouch::guard {
namespace {

using Value = std::array<int, 100>;

TEST(PrivateMemory, KeepsWhatItsOwnerPuts) {
  PrivateMemory<Value> memory;
  ASSERT_NE(memory.get(), nullptr);
  EXPECT_EQ((*memory.get())[99], 0);
  Value value{};
  value[99] = 7;
  EXPECT_TRUE(memory.put(value));
  EXPECT_EQ((*memory.get())[99], 7);
}

TEST(PrivateMemoryDeathTest, NobodyElseCanWriteIt) {
  PrivateMemory<Value> memory;
  ASSERT_NE(memory.get(), nullptr);
  EXPECT_DEATH(
      {
        volatile int* const stray = const_cast<int*>(memory.get()->data());
        stray[3] = 1;
      },
      "");
}

}  // namespace
}  // namespace isotouch::guard
