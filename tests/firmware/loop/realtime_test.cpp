#include "firmware/loop/realtime.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <cstddef>
#include <thread>

namespace isotouch::loop {
namespace {

std::size_t stack_of_this_thread() {
  pthread_attr_t attributes;
  pthread_getattr_np(pthread_self(), &attributes);
  std::size_t bytes = 0;
  pthread_attr_getstacksize(&attributes, &bytes);
  pthread_attr_destroy(&attributes);
  return bytes;
}

TEST(Realtime, ThreadsBegunAfterTheLimitHaveSmallStacks) {
  limit_stacks();
  std::size_t bytes = 0;
  std::thread([&] { bytes = stack_of_this_thread(); }).join();
  EXPECT_EQ(bytes, kThreadStackBytes);
}

}  // namespace
}  // namespace isotouch::loop
