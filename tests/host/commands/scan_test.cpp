#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/host/commands/run_command.h"
#include "tests/host/field/box_mesh.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

using field::box_mesh;

TEST(Scan, APieceThatFacesInwardsIsRefusedAsByBuild) {
  const ScratchFolder folder;
  const std::string at = folder.path().string() + "/";
  const auto mesh = field::together(box_mesh({0, 0, 0}, {10, 10, 10}), field::turned(box_mesh({20, 0, 0}, {24, 4, 4})));
  {
    std::ofstream out(at + "two.obj");
    for (const auto& v : mesh.vertices) out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    for (const auto& [a, b, c] : mesh.faces) out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  const std::string sentence = complaint_on("scan " + at + "two.obj -o " + at + "two.ply --trace " + at + "two.trace --seconds 1");
  EXPECT_THAT(sentence, ::testing::HasSubstr("a closed piece of 12 faces near (2"));
  EXPECT_EQ(sentence, complaint_on("build " + at + "two.obj -o " + at + "two.itf"));
}

}  // namespace
}  // namespace isotouch::commands
