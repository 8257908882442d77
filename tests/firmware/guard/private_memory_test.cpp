#include "firmware/guard/private_memory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

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

TEST(PrivateMemory, NoticesThatAnotherFileWasWritten) {
  const int other = memfd_create("other", MFD_CLOEXEC);
  ASSERT_GE(other, 0);
  PrivateMemory<Value> memory;
  Value value{};
  value[99] = 7;
  int own = -1;
  std::memcpy(&own, &memory, sizeof own);
  std::memcpy(reinterpret_cast<char*>(&memory), &other, sizeof other);  // as a flipped bit of its number
  EXPECT_FALSE(memory.put(value));
  std::memcpy(reinterpret_cast<char*>(&memory), &own, sizeof own);
  EXPECT_TRUE(memory.put(value));
  close(other);
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
