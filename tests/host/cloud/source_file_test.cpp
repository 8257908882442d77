#include "host/cloud/source_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>
#include <thread>

#include "host/cloud/read_cloud.h"
#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

std::string cube() {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 8\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += std::string("property float ") + name + "\n";
  text += "end_header\n";
  for (int corner = 0; corner < 8; ++corner) {
    const auto place = [&](int axis) { return (corner >> axis & 1) != 0 ? "1 " : "-1 "; };
    const std::string row = std::string(place(0)) + place(1) + place(2);
    text += row + row + "\n";
  }
  return text;
}

/// What comes out of a pipe can be read only once.
TEST(SourceFile, IsReadOnce) {
  const ScratchFolder folder;
  const std::filesystem::path pipe = folder.path() / "cloud.ply";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << cube(); });
  const SourceFile source(pipe);
  writer.join();
  EXPECT_FALSE(source.is_mesh());
  CloudReport report;
  EXPECT_EQ(read_cloud(source, report).size(), 8U);
  EXPECT_EQ(report.source_hash, source.hash());
}

TEST(SourceFile, ABrokenHeaderAndAnEmptyFileAreRefusedAtOnce) {
  const ScratchFolder folder;
  EXPECT_THROW(SourceFile(folder.write("a.ply", "ply\nformat nonsense\n")), InputError);
  EXPECT_THROW(SourceFile(folder.write("a.xyz", "")), InputError);
  EXPECT_THROW(SourceFile(folder.path() / "none.xyz"), InputError);
}

}  // namespace
}  // namespace isotouch::cloud
