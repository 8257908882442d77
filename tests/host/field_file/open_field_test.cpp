#include "host/field_file/open_field.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::field_file {
namespace {

std::string refusal_of(const std::filesystem::path& file) {
  try {
    (void)open_field(file);
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.substr(0, file.string().size()), file.string());
    return sentence.substr(file.string().size());
  }
  return "it was opened";
}

TEST(OpenField, SaysWhatStandsInItsPlace) {
  const ScratchFolder folder;
  const std::filesystem::path golden = ISOTOUCH_GOLDEN;
  EXPECT_EQ(refusal_of(folder.write("a.ply", "ply\nformat ascii 1.0\n")),
            ": is no field; make one of a scan or a mesh with isotouch build");
  EXPECT_EQ(refusal_of(golden / "packets.trace"), ": is a trace, no field; name the field that it was recorded on");
  EXPECT_EQ(refusal_of(golden / "positions_patches.patches"), ": holds patches, no field; name the field that they are for");
  EXPECT_EQ(refusal_of(folder.write("a.itf", "version https://git-lfs.github.com/spec/v1\n")),
            ": is a Git LFS pointer; fetch the file with git lfs pull");
  EXPECT_EQ(refusal_of(folder.write("b.itf", "ITFB and nothing else")).substr(0, 25), ": not usable as a field: ");
}

}  // namespace
}  // namespace isotouch::field_file
