#include "host/cloud/xyz.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Model read(const std::string& text) { return read_xyz("f.xyz", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

std::vector<Vector3d> read_places(const std::string& text) {
  return read_xyz_positions("f.xyz", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

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

/// What it refuses with.
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Xyz, AnEmptyCellIsACell) {
  for (const char* text : {",x,y,z,label\n0,1,2,3,\n1,4,5,6,\n", "id;x;y;z\n;1;2;3\n;4;5;6\n", "a\tb\tx\ty\tz\n\t\t1\t2\t3\n\t\t4\t5\t6\n",
                           "Point ID, x, y, z,\n7, 1, 2, 3,\n8, 4, 5, 6\n", "x,y,z\n1 2 3\n4 5 6\n", "x\t\ty\t\tz\n1\t2\t3\n4\t5\t6\n"}) {
    const Model model = read(text);
    ASSERT_EQ(model.positions.size(), 2U) << text;
    EXPECT_EQ(model.positions[0], Vector3d(1, 2, 3)) << text;
    EXPECT_EQ(model.positions[1], Vector3d(4, 5, 6)) << text;
  }
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n,1,2,3\n"), "f.xyz: line 3: not 3 values, as many as the line of names has");
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n1,,3\n"), "f.xyz: line 3: '' is no number; 'y' should stand there");
}

TEST(Xyz, CellsBelowNamesWithTabsMayBeSeparatedByBlanks) {
  EXPECT_EQ(read("x\ty\tz\tintensity\n1 2 3\t50\n").positions[0], Vector3d(1, 2, 3));
  for (const char* text : {"nx\tny\tnz\tx\ty\tz\n0 0 1\t1 2 3\n", "#nx\tny\tnz\tx\ty\tz\n0 0 1\t1 2 3\n"}) {
    const Model model = read(text);
    EXPECT_EQ(model.positions[0], Vector3d(1, 2, 3)) << text;
    EXPECT_EQ(model.normals.at(0), Vector3d(0, 0, 1)) << text;
  }
  EXPECT_EQ(refusal("x\ty\tz\tid\n1 2\t3\n"), "f.xyz: line 2: not 4 values, as many as the line of names has");
}

TEST(Xyz, ARemarkOfNamesInAnotherOrderIsNotForgotten) {
  EXPECT_EQ(refusal("# z y x\n3 2 1 0 0 1\n"),
            "f.xyz: line 2: not 3 values, as many columns as a remark above names; correct that remark or remove it");
  EXPECT_EQ(refusal("# nx ny nz x y z id\n0 0 1 1 2 3\n").substr(0, 28), "f.xyz: line 2: not 7 values,");
  EXPECT_EQ(refusal("# z y x\n3 2 1\n3 2\n"), "f.xyz: line 3: not 3 values, as many as the line of names has") << "it is no doubt meant";
  EXPECT_EQ(read("# x y z\n1 2 3 0 0 1\n").normals.size(), 1U);
  EXPECT_EQ(read("# x, y and z in mm, nx ny nz unit\n1 2 3 0 0 1\n").normals.size(), 1U);
}

TEST(Xyz, NamesAreSplitAsTheyNameMore) {
  for (const char* text : {"x,y,z,nx ny nz\n1,2,3,0 0 1\n", "x,y,z,nx,ny nz\n1,2,3,0,0 1\n", "x\ty\tz\tnx ny nz\n1\t2\t3\t0 0 1\n"}) {
    const Model model = read(text);
    EXPECT_EQ(model.positions[0], Vector3d(1, 2, 3)) << text;
    ASSERT_EQ(model.normals.size(), 1U) << text;
    EXPECT_EQ(model.normals[0], Vector3d(0, 0, 1)) << text;
  }
  for (const char* text :
       {"x,y,z,angle to x\n1,2,3,9\n", ",x,y,z,stiffness of it\n0,1,2,3,9\n", ",x,y,z,my nx,my ny,my nz\n0,1,2,3,9,9,9\n"})
    EXPECT_EQ(read(text).positions[0], Vector3d(1, 2, 3)) << text;
}

TEST(Xyz, NamesThatContradictEachOtherAreRefused) {
  EXPECT_EQ(refusal("x,y,z,x,y,z\n1,2,3,4,5,6\n"), "f.xyz: line 1: columns 'x' and 'x' are the same; remove one of them");
  EXPECT_EQ(refusal("x,y,z,nx,ny\n1,2,3,0,0\n"), "f.xyz: line 1: only a part of nx, ny, nz is named; a normal needs all three");
  EXPECT_EQ(read("X,Y,Z,x,y,z\n1,2,3,4,5,6\n").positions[0], Vector3d(4, 5, 6)) << "the format's own names count";
}

TEST(Xyz, ARemarkOfNothingButNamesIsFollowed) {
  EXPECT_EQ(read("# z y x\n3 2 1\n").positions[0], Vector3d(1, 2, 3));
  EXPECT_EQ(read("# z y x go on\n3 2 1\n").positions[0], Vector3d(3, 2, 1)) << "a sentence";
}

TEST(Xyz, AColumnOfStiffnessIsRead) {
  const Model model = read("x,y,z,Stiffness\n1,2,3,0.2\n4,5,6,1.5\n");
  EXPECT_EQ(model.stiffness, (std::vector<double>{0.2, 1.5}));
  EXPECT_TRUE(model.normals.empty());
  EXPECT_EQ(read("stiffness x y z nx ny nz\n0.2 1 2 3 0 0 1\n").stiffness, (std::vector<double>{0.2}));
}

TEST(Xyz, OfPlacesOnlyTheirThreeNumbersCount) {
  for (const char* text : {"1 2 3 7\n4 5 6\n", "1,2,3,10,20,30\n4,5,6,255,0,0\n", "1 2 3 4 5 6 7 8\n4 5 6 a label\n", "2\n1 2 3\n4 5 6\n",
                           "nx,x,y,z\n0,1,2,3\n0,4,5,6\n", "# nx ny nz x y z\n0 0 1 1 2 3\n0 0 1 4 5 6\n"}) {
    const std::vector<Vector3d> places = read_places(text);
    ASSERT_EQ(places.size(), 2U) << text;
    EXPECT_EQ(places[0], Vector3d(1, 2, 3)) << text;
    EXPECT_EQ(places[1], Vector3d(4, 5, 6)) << text;
  }
  for (const char* text : {"1 2\n", "1 2 nan\n", "1,5 2,5 3,5\n", "3\n1 2 3\n", "# nx ny nz x y z id\n0 0 1 1 2 3\n"})
    EXPECT_THROW(read_places(text), InputError) << text;
}

TEST(Xyz, OtherNamesGetARemedy) {
  const std::string remedy =
      "f.xyz: line 1: 'px' is no number; a coordinate should stand there, or a first line must name the columns x, y and z";
  EXPECT_EQ(refusal("px,py,pz\n1,2,3\n"), remedy);
  try {
    read_places("px,py,pz\n1,2,3\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), remedy);
  }
}

}  // namespace
}  // namespace isotouch::cloud
