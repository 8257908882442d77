#include "host/cloud/mesh_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "host/cloud/read_mesh.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

TriangleMesh tetrahedron(const Vector3d& moved) {
  TriangleMesh mesh;
  for (const Vector3d& v : {Vector3d(0.1, 0.2, 0.3), Vector3d(1.1, 0.25, 0.3), Vector3d(0.1, 1.3, 0.2), Vector3d(0.2, 0.1, 1.4)})
    mesh.vertices.push_back(v + moved);
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TriangleMesh read_back(const std::string& name, std::vector<std::uint8_t> bytes) {
  MeshReport report;
  const SourceFile file(name, std::move(bytes));
  EXPECT_TRUE(file.is_mesh()) << name;
  return read_mesh(file, report);
}

/// The farthest that a corner of a face was moved; faces in their order.
double moved(const TriangleMesh& from, const TriangleMesh& to) {
  EXPECT_EQ(from.faces.size(), to.faces.size());
  double farthest = 0;
  for (std::size_t face = 0; face < std::min(from.faces.size(), to.faces.size()); ++face) {
    for (std::size_t n = 0; n < 3; ++n)
      farthest = std::max(farthest, (from.vertices[from.faces[face][n]] - to.vertices[to.faces[face][n]]).norm());
  }
  return farthest;
}

TEST(MeshBytes, EveryFormatIsReadBackClosedWithItsFacesTheSameWayRound) {
  const TriangleMesh mesh = tetrahedron(Vector3d::Zero());
  const TriangleMesh ply = read_back("a.ply", ply_bytes(mesh, "a comment"));
  const TriangleMesh obj = read_back("a.obj", obj_bytes(mesh, "a comment", 1e-4));
  const TriangleMesh stl = read_back("a.stl", stl_bytes(mesh, "a.stl", "a comment", 1e-4));
  for (const TriangleMesh* read : {&ply, &obj, &stl}) {
    EXPECT_NO_THROW(require_closed(*read, "a"));
    EXPECT_EQ(read->vertices.size(), 4U);
  }
  EXPECT_EQ(moved(mesh, ply), 0);
  EXPECT_EQ(moved(mesh, obj), 0) << "four places tell these numbers";
  EXPECT_LT(moved(mesh, stl), 1e-6);
  EXPECT_GT(moved(mesh, stl), 1e-9) << "single precision cannot be this good";
}

TEST(MeshBytes, CoordinatesFarFromTheOriginKeepTheirDigitsOrAreRefused) {
  const TriangleMesh mesh = tetrahedron({431250.5, -5400321.25, 812});
  EXPECT_EQ(moved(mesh, read_back("a.ply", ply_bytes(mesh, ""))), 0);
  EXPECT_LT(moved(mesh, read_back("a.obj", obj_bytes(mesh, "", 1e-6))), 1e-6);
  EXPECT_GT(moved(mesh, read_back("a.obj", obj_bytes(mesh, "", 0.1))), 0.01);
  try {
    (void)stl_bytes(mesh, "a.stl", "", 1e-3);
    FAIL() << "these numbers are half a unit apart";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("a.stl: an STL file cannot hold this surface"));
    EXPECT_THAT(e.what(), HasSubstr("0.500000 apart; write PLY or OBJ"));
  }
}

TEST(MeshBytes, ObjHoldsNumbersOfEveryLength) {
  TriangleMesh mesh = tetrahedron(Vector3d::Zero());
  for (Vector3d& vertex : mesh.vertices) vertex *= -1e308;
  const std::vector<std::uint8_t> bytes = obj_bytes(mesh, "", 1e-17);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  std::string word;
  std::getline(text, word);
  for (const Vector3d& vertex : mesh.vertices) {
    text >> word;
    EXPECT_EQ(word, "v");
    for (const double value : vertex) {
      text >> word;
      EXPECT_EQ(std::stod(word), value);
    }
  }
}

TEST(MeshBytes, AnStlFileIsNoTextWhateverItsComment) {
  const TriangleMesh mesh = tetrahedron(Vector3d::Zero());
  const std::vector<std::uint8_t> bytes = stl_bytes(mesh, "a.stl", std::string(200, 'x'), 1);
  EXPECT_EQ(bytes.size(), 84U + 4 * 50);
  EXPECT_EQ(bytes[79], 0) << "the header's last byte";
}

}  // namespace
}  // namespace isotouch::cloud
