#include "firmware/recording/numbered_traces.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace isotouch::recording {
namespace {

TEST(NumberedTraces, TheNextNumberIsAboveEveryOneInUse) {
  const ScratchFolder folder;
  const std::string in = folder.path().string() + "/", name = in + "r.trace";
  EXPECT_EQ(NumberedTraces(name).next(), in + "r-1.trace");
  for (const char* other : {"r.trace", "r-x.trace", "r-9x.trace", "ar-9.trace", "r-.trace", "r--9.trace", "R-9.trace", "r 9.trace"}) {
    std::ofstream(in + other) << "no number of these";
  }
  EXPECT_EQ(NumberedTraces(name).next(), in + "r-1.trace");
  std::size_t number = 2;
  for (const char* kind : {".trace", ".trace.part", ".patches", ".patches.part", ".trace", ""}) {
    std::ofstream(in + "r-" + std::to_string(number) + kind) << "in use";
    EXPECT_EQ(NumberedTraces(name).next(), in + "r-" + std::to_string(++number) + ".trace") << kind;
  }
  std::filesystem::create_symlink("nowhere", in + "r-99.trace.part");
  EXPECT_EQ(NumberedTraces(name).next(), in + "r-100.trace");
}

TEST(NumberedTraces, BehindTheLargestNumberAFreeOneComes) {
  const ScratchFolder folder;
  const std::string in = folder.path().string() + "/", name = in + "r.trace";
  for (const char* other : {"r-18446744073709551615.trace", "r-0.trace", "r-1.trace"}) std::ofstream(in + other) << "in use";
  EXPECT_EQ(NumberedTraces(name).next(), in + "r-2.trace");
}

TEST(NumberedTraces, AnyNameHasNumbers) {
  const ScratchFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::create_directory(folder.path() / "a.b");
  std::filesystem::current_path(folder.path());
  for (const auto& [name, first, second] : std::vector<std::array<std::string, 3>>{{"r.trace", "r-1.trace", "r-2.trace"},
                                                                                   {"r", "r-1", "r-2"},
                                                                                   {"a.b/r", "a.b/r-1", "a.b/r-2"},
                                                                                   {".r", ".r-1", ".r-2"},
                                                                                   {"q.v2.rec", "q.v2-1.rec", "q.v2-2.rec"}}) {
    std::filesystem::remove("r-1.trace");
    EXPECT_EQ(NumberedTraces(name).next(), first);
    std::ofstream(first) << "the first";
    EXPECT_EQ(NumberedTraces(name).next(), second);
  }
  EXPECT_EQ(NumberedTraces("nowhere/r.trace").next(), "nowhere/r-1.trace");
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace isotouch::recording
