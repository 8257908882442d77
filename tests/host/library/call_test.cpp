#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "host/library/isotouch.h"

namespace isotouch {
namespace {

/// A program may print it from its own last function.
TEST(LibraryCall, TheVersionStaysUntilTheProcessHasEnded) {
  static const char* version = nullptr;
  const auto end = [] {
    std::atexit([] { std::_Exit(std::strncmp(version, "isotouch ", 9) == 0 ? 0 : 1); });
    version = isotouch_version();
    std::exit(2);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace isotouch
