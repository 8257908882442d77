#include "host/cloud/read_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

std::string ply(const std::string& properties, const std::string& row, const std::string& faces) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + properties;
  text += "element face " + std::string(faces.empty() ? "0" : "1") + "\nproperty list uchar int vertex_indices\nend_header\n";
  return text + "0 0 0" + row + "\n1 0 0" + row + "\n0 1 0" + row + "\n" + faces;
}

bool is_mesh(const std::filesystem::path& file) { return SourceFile(file).is_mesh(); }

TEST(ReadMesh, FacesWithoutNormalsAreAMeshAndNormalsACloud) {
  const ScratchFolder folder;
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  EXPECT_TRUE(is_mesh(folder.write("a.stl", "solid\nendsolid\n")));
  EXPECT_TRUE(is_mesh(folder.write("a.ply", ply("", "", "3 0 1 2\n"))));
  EXPECT_FALSE(is_mesh(folder.write("b.ply", ply(normals, " 0 0 1", "3 0 1 2\n"))));
  EXPECT_FALSE(is_mesh(folder.write("c.ply", ply("", "", ""))));
  EXPECT_TRUE(is_mesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")));
  EXPECT_FALSE(is_mesh(folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")));
  EXPECT_FALSE(is_mesh(folder.write("c.obj", "v 0 0 0\n")));
  EXPECT_FALSE(is_mesh(folder.write("a.xyz", "0 0 0 0 0 1\n")));
  EXPECT_FALSE(is_mesh(folder.write("a.what", "0 0 0 0 0 1\n")));
}

TEST(ReadMesh, TellsTheFormatAndDropsVerticesWithoutAFace) {
  const ScratchFolder folder;
  MeshReport report;
  const TriangleMesh mesh = read_mesh(folder.write("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n"), report);
  EXPECT_EQ(report.format, "OBJ");
  EXPECT_NE(report.source_hash, 0U);
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(mesh.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(ReadMesh, CoordinatesThatNoUnitExplainsAreRefused) {
  const ScratchFolder folder;
  try {
    read_mesh(folder.write("a.obj", "v 0 0 0\nv 1e13 0 0\nv 0 1 0\nf 1 2 3\n"));
    FAIL() << "no refusal";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("a.obj: line 2: a coordinate is larger than 1e12"));
  }
}

/// A prism of six sides with an L for its caps, whose first corners are these; 12 vertices, 8 polygons.
std::string ell_prism(bool obj, int lower, int upper) {
  const int xy[6][2] = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  std::string vertices, faces;
  for (const int z : {0, 2}) {
    for (const auto& [x, y] : xy)
      vertices += (obj ? "v " : "") + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
  }
  const auto face = [&](const std::vector<int>& corners) {
    faces += obj ? "f" : std::to_string(corners.size());
    for (const int corner : corners) faces += ' ' + std::to_string(corner + (obj ? 1 : 0));
    faces += '\n';
  };
  std::vector<int> below, above;
  for (int i = 0; i < 6; ++i) {
    below.push_back((lower + 6 - i) % 6);
    above.push_back(6 + (upper + i) % 6);
    face({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
  }
  face(below);
  face(above);
  if (obj) return vertices + faces;
  return "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 8\nproperty list uchar int vertex_indices\nend_header\n" +
         vertices + faces;
}

TEST(ReadMesh, APolygonMayBeginAtAnyOfItsCorners) {
  const ScratchFolder folder;
  for (const bool obj : {true, false}) {
    for (int lower = 0; lower < 6; ++lower) {
      for (int upper = 0; upper < 6; ++upper) {
        const TriangleMesh mesh = read_mesh(folder.write(obj ? "l.obj" : "l.ply", ell_prism(obj, lower, upper)));
        EXPECT_NO_THROW(require_closed(mesh, "l"));
        double surface = 0;
        for (const auto& [a, b, c] : mesh.faces) {
          surface += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
        }
        EXPECT_NEAR(surface, 2 * 6 + 2 * 14, 1e-9) << lower << ' ' << upper;
        EXPECT_NEAR(signed_volume(mesh), 12, 1e-9) << lower << ' ' << upper;
      }
    }
  }
}

}  // namespace
}  // namespace isotouch::cloud
