#include "host/cloud/xyz.h"

#include <gtest/gtest.h>

#include <string>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Model read(const std::string& text) { return read_xyz("f.xyz", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

TEST(Xyz, EveryCustomaryDressGivesTheSamePoints) {
  for (const char* text : {"1 2 3 0 0 1\n4 5 6 0 1 0\n", "2\n1 2 3 0 0 1\n4 5 6 0 1 0\n",
                           "# remark\r\n1,2,3,0,0,1\r\n\r\n// remark\r\n4;5;6;0;1;0", "  1\t2\t3\t0\t0\t1e0  \n+4 5. 6.0 0 1 -0\n",
                           "2\n1 2 3\n4 5 6\n0 0 1\n0 1 0\n", "1,2,3 0,0,1\n4,5,6 0,1,0\n", "1, 2, 3, 0, 0, 1\n4, 5, 6, 0, 1, 0\n",
                           "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,5,6,0,1,0\n", "//X Y Z R G B Nx Ny Nz\n1 2 3 9 9 9 0 0 1\n4 5 6 9 9 9 0 1 0\n",
                           "# Normal_X, Normal_Y, Normal_Z, \"X\", \"Y\", \"Z\"\n0,0,1,1,2,3\n0,1,0,4,5,6\n",
                           "name;x;y;z;nx;ny;nz\na;1;2;3;0;0;1\nb;4;5;6;0;1;0\n", "# x y z of a scan\n1 2 3 0 0 1\n4 5 6 0 1 0\n"}) {
    const Model model = read(text);
    ASSERT_EQ(model.positions.size(), 2U) << text;
    ASSERT_EQ(model.normals.size(), 2U) << text;
    EXPECT_EQ(model.positions[1], Vector3d(4, 5, 6)) << text;
    EXPECT_EQ(model.normals[0], Vector3d(0, 0, 1)) << text;
    EXPECT_EQ(model.normals[1], Vector3d(0, 1, 0)) << text;
  }
}

TEST(Xyz, PlacesAreTheFilesLines) { EXPECT_EQ(read("# remark\n2\n1 2 3 0 0 1\n\n4 5 6 0 1 0\n").lines, (std::vector<std::size_t>{3, 5})); }

TEST(Xyz, ColumnsWithOtherNamesAreNoNormals) {
  const Model model = read("x,y,z,r,g,b\n1,2,3,0,0,1\n4,5,6,0,1,0\n");
  EXPECT_EQ(model.positions.size(), 2U);
  EXPECT_TRUE(model.normals.empty());
}

TEST(Xyz, ColoursWithoutNamesAreRefused) {
  EXPECT_THROW(read("1 2 3 0.8 0.81 0.79\n4 5 6 0.5 0.9 0.7\n7 8 9 0.6 0.5 0.6\n"), InputError);
  EXPECT_EQ(read("x y z nx ny nz\n1 2 3 0.8 0.81 0.79\n").normals.size(), 1U) << "somebody says so";
  EXPECT_EQ(read("1 2 3 0.8 0.81 0.79\n4 5 6 -0.5 0.9 0.7\n").normals.size(), 2U);
  EXPECT_EQ(read("1 2 3 0.6 0.6 0.55\n4 5 6 0 0 1\n").normals.size(), 2U) << "a corner, with few digits";
}

TEST(Xyz, ALineMustHoldWhatTheNamesSay) {
  try {
    read("x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,5,6\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f.xyz: line 3: not 6 values, as many as the line of names has");
  }
  EXPECT_THROW(read("x,y,z\n1,two,3\n"), InputError);
  EXPECT_THROW(read("x,y,z\n1,nan,3\n"), InputError);
}

TEST(Xyz, PositionsAloneHaveNoNormals) { EXPECT_TRUE(read("1 2 3\n4 5 6\n").normals.empty()); }

}  // namespace
}  // namespace isotouch::cloud
