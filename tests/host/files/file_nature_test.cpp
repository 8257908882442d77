#include "host/files/file_nature.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

TEST(FileNature, IsKnownByTheFirstBytes) {
  const auto golden = [](const char* name) { return nature_of(std::filesystem::path(ISOTOUCH_GOLDEN) / name); };
  EXPECT_EQ(golden("field_1_1.itf"), FileNature::kField);
  EXPECT_EQ(golden("packed_1_0.itf"), FileNature::kField);
  EXPECT_EQ(golden("packets.trace"), FileNature::kTrace);
  EXPECT_EQ(golden("positions_patches.patches"), FileNature::kPatches);
  const ScratchFolder folder;
  EXPECT_EQ(nature_of(folder.write("a.itf", "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n")), FileNature::kPointer);
  EXPECT_EQ(nature_of(folder.write("a.txt", "version https://example.org\n")), FileNature::kUnknown);
  EXPECT_EQ(nature_of(folder.write("empty", "")), FileNature::kUnknown);
  EXPECT_EQ(nature_of(folder.path() / "none"), FileNature::kUnknown);
}

}  // namespace
}  // namespace isotouch
