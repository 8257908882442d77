#include "host/cloud/content_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace isotouch::cloud {
namespace {

FileKind kind(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(file_kind("-", bytes), file_kind("/dev/fd/63", bytes));
  EXPECT_EQ(file_kind("a.unknown", bytes), FileKind::kUnknown) << "an ending is believed";
  return file_kind("-", bytes);
}

TEST(ContentKind, IsToldByTheFirstWords) {
  EXPECT_EQ(kind("# by hand\n\n1 2 3 0 0 1\n"), FileKind::kText);
  EXPECT_EQ(kind("-1e-3,2,3\n"), FileKind::kText);
  EXPECT_EQ(kind("x,y,z\n1,2,3\n"), FileKind::kText);
  EXPECT_EQ(kind("# Blender\nmtllib a.mtl\no Cube\nv 1 2 3\n"), FileKind::kObj);
  EXPECT_EQ(kind("vn 1 2 3\n"), FileKind::kObj);
  EXPECT_EQ(kind("solid cube\nfacet normal 0 0 1\n"), FileKind::kStl);
  EXPECT_EQ(kind("lorem ipsum\ndolor sit\namet\n"), FileKind::kUnknown);
  EXPECT_EQ(kind("\x7f"
                 "ELF"),
            FileKind::kUnknown);
  EXPECT_EQ(kind(""), FileKind::kUnknown);
}

TEST(ContentKind, ABinaryStlFileIsToldByItsSize) {
  std::string stl(84 + 2 * 50, '\0');
  stl[80] = 2;
  EXPECT_EQ(kind(stl), FileKind::kStl);
  stl.pop_back();
  EXPECT_EQ(kind(stl), FileKind::kUnknown);
}

}  // namespace
}  // namespace isotouch::cloud
