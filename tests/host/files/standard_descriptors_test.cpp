#include "shared/files/standard_descriptors.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include <string>

#include "host/error.h"
#include "host/files/whole_file.h"

namespace isotouch::files {
namespace {

/// Ends with 0 if all three are taken, and those that were closed can be neither read nor written.
[[noreturn]] void close_and_occupy(int closed) {
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if ((closed >> descriptor & 1) != 0) close(descriptor);
  }
  occupy_standard_descriptors();
  char byte = 'x';
  bool good = open("/dev/null", O_RDONLY) > 2;
  if ((closed & 1) != 0) good = good && read(0, &byte, 1) < 0;
  for (int descriptor = 1; descriptor < 3; ++descriptor) {
    if ((closed >> descriptor & 1) != 0) good = good && write(descriptor, &byte, 1) < 0;
  }
  _exit(good ? 0 : 1);
}

TEST(StandardDescriptorsDeathTest, NoFileGetsTheNumberOfOneThatIsClosed) {
  for (int closed = 0; closed < 8; ++closed) EXPECT_EXIT(close_and_occupy(closed), testing::ExitedWithCode(0), "") << closed;
}

/// Ends with 0 if it is said that standard input is closed.
[[noreturn]] void close_and_claim() {
  close(0);
  occupy_standard_descriptors();
  try {
    claim_standard_input();
  } catch (const InputError& error) {
    _exit(std::string(error.what()).starts_with("-: standard input is closed") ? 0 : 1);
  }
  _exit(2);
}

TEST(StandardDescriptorsDeathTest, WhoeverReadsAClosedInputIsTold) { EXPECT_EXIT(close_and_claim(), testing::ExitedWithCode(0), ""); }

}  // namespace
}  // namespace isotouch::files
