#include "host/cloud/obj.h"

#include <gtest/gtest.h>

#include <string>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

const std::string kSquare =
    "# a remark\nmtllib away.mtl\no square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nvn 0 1 0\nusemtl none\ns off\n";

TEST(Obj, NormalsAreFoundThroughTheFaces) {
  const std::string text = kSquare + "f 1/1/1 2/1/1 -2/1/-2\nf 1//1 3//1 4//2\n";
  const Model model = read_obj_points("f.obj", bytes_of(text));
  const std::vector<Vector3d> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(model.positions, positions);
  const std::vector<Vector3d> normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(model.normals, normals);
}

TEST(Obj, AVertexWithTwoNormalsGivesTwoPoints) {
  const std::string text = kSquare + "f 1//1 2//1 3//1\nf 1//2 3//1 4//1\n";
  const Model model = read_obj_points("f.obj", bytes_of(text));
  EXPECT_EQ(model.positions.size(), 5U);
  EXPECT_EQ(model.positions[3], Vector3d(0, 0, 0));
  EXPECT_EQ(model.normals[3], Vector3d(0, 1, 0));
}

TEST(Obj, WithoutFacesNormalsBelongToVerticesInOrder) {
  const std::string text = "v 1 2 3\nvn 0 0 1\nv 4 5 6\nvn 0 1 0\n";
  const Model model = read_obj_points("f.obj", bytes_of(text));
  ASSERT_EQ(model.positions.size(), 2U);
  EXPECT_EQ(model.normals[1], Vector3d(0, 1, 0));
}

TEST(Obj, WithoutNormalsThereAreNone) {
  const std::string text = kSquare + "f 1 2 3 4\n";
  EXPECT_TRUE(read_obj_points("f.obj", bytes_of("v 1 2 3\n")).normals.empty());
  const Model faces = read_obj_faces("f.obj", bytes_of(text));
  EXPECT_EQ(faces.faces.size(), 2U);
  EXPECT_EQ(faces.positions.size(), 4U);
}

TEST(Obj, NormalsThatNoFaceUsesMakeNoCloud) {
  const std::string text = kSquare + "f 1 2 3 4\n";
  EXPECT_TRUE(is_bare_obj_mesh("f.obj", bytes_of(text)));
  EXPECT_TRUE(read_obj_points("f.obj", bytes_of(text)).normals.empty());
  EXPECT_FALSE(is_bare_obj_mesh("f.obj", bytes_of(kSquare + "f 1//1 2//1 3//1\n")));
  EXPECT_FALSE(is_bare_obj_mesh("f.obj", bytes_of(kSquare)));
  EXPECT_THROW(read_obj_points("f.obj", bytes_of(kSquare + "f 1 2//1 3//1\n")), InputError);
}

TEST(Obj, ALineMayGoOnInTheNext) {
  const std::string text = "v 0 0 \\\n0\nv 1 0 0\r\nv 1 1\\\r\n 0\nv 0 1 0\nf 1 2 \\\n 3 \\\n4\n";
  EXPECT_TRUE(is_bare_obj_mesh("f.obj", bytes_of(text)));
  const Model model = read_obj_faces("f.obj", bytes_of(text));
  EXPECT_EQ(model.positions, (std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(model.faces.size(), 2U);
  EXPECT_EQ(model.lines, (std::vector<std::size_t>{2, 3, 5, 6}));
}

/// Paths of Windows end in one, too.
TEST(Obj, OnlyStatementsThatAreReadGoOn) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0 # from C:\\scans\\\nv 0 1 0\n";
  for (const std::string line :
       {"# made from C:\\scans\\", "#\\", "mtllib C:\\scans\\", "o C:\\scans\\", "g a \\", "usemtl C:\\v\\", "vt 0 \\"}) {
    for (const std::string end : {"\n", "\r\n"}) {
      const std::string text = line + end + vertices + line + end + "f 1 2 3 4\n";
      EXPECT_TRUE(is_bare_obj_mesh("f.obj", bytes_of(text))) << line;
      const Model model = read_obj_faces("f.obj", bytes_of(text));
      EXPECT_EQ(model.positions, (std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})) << line;
      EXPECT_EQ(model.faces.size(), 2U) << line;
      EXPECT_EQ(model.lines, (std::vector<std::size_t>{2, 3, 4, 5})) << line;
    }
  }
}

TEST(Obj, DecimalCommasAreRefused) {
  for (const std::string line : {"v 1,5 2,5 3,5", "v 1,5 2 3,25 1,0", "vn 0,5 0,5 0,7"}) {
    try {
      read_obj_points("f.obj", bytes_of("v 0 0 0\n" + line + "\n"));
      ADD_FAILURE() << line;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "f.obj: line 2: its numbers have decimal commas; save them with decimal points");
    }
  }
  EXPECT_EQ(read_obj_points("f.obj", bytes_of("v 1, 2, 3\nv 1,2,3\n")).positions[1], Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace isotouch::cloud
