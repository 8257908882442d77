#include "host/cloud/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "host/cloud/read_mesh.h"
#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

const std::string kTetrahedron =
    "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no refusal";
}

TEST(Mesh, ATetrahedronIsClosedAndHasItsVolume) {
  const ScratchFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("a.obj", kTetrahedron));
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.faces.size(), 4U);
  EXPECT_DOUBLE_EQ(signed_volume(mesh), 4.5);
  require_closed(mesh, "a.obj");
  EXPECT_EQ(face_normal(mesh, 0), Vector3d(0, 0, -1));
}

TEST(Mesh, SeamsAreJoinedAndFacesWithoutExtentDropped) {
  const ScratchFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("a.obj",
                                                   "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nv 0 0 0\nv 3 0 0\n"
                                                   "f 1 3 2\nf 5 6 4\nf 1 4 3\nf 2 3 4\nf 1 5 2\n"));
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.faces.size(), 4U);
  require_closed(mesh, "a.obj");
}

TEST(Mesh, AHoleAFinAndAnInsideOutMeshAreRefused) {
  const ScratchFolder folder;
  const std::string vertices = "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\n";
  const auto complaint = [&](const std::string& text) {
    const TriangleMesh mesh = read_mesh(folder.write("a.obj", text));
    return refusal([&] { require_closed(mesh, "a.obj"); });
  };
  EXPECT_THAT(complaint(vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\n"),
              ::testing::StartsWith("a.obj: the mesh is not closed: 3 of its 9 face edges"));
  EXPECT_THAT(complaint(kTetrahedron + "v 9 9 9\nf 1 2 5\n"), ::testing::HasSubstr("not closed"));
  EXPECT_THAT(complaint(kTetrahedron + "f 1 3 2\n"), ::testing::HasSubstr("not closed"));
  EXPECT_THAT(complaint(vertices + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"), ::testing::HasSubstr("point inwards"));
}

TEST(Mesh, WithoutFacesIsRefused) {
  const ScratchFolder folder;
  const auto file = folder.write("a.obj", "v 0 0 0\n");
  EXPECT_EQ(refusal([&] { read_mesh(file); }), file.string() + ": has points and no faces; a mesh is a closed surface of faces");
}

TEST(Mesh, ScatteredPointsLieOnTheFacesInProportionToTheirArea) {
  const ScratchFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("a.obj", kTetrahedron));
  const OrientedPoints points = scatter_on_mesh(mesh, 20000, 1);
  ASSERT_EQ(points.size(), 20000U);
  double on_slope = 0.0;
  Vector3d mean_on_slope = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& p = points.positions[i];
    if (points.normals[i].x() > 0.5) {
      on_slope += 1.0;
      mean_on_slope += p;
      ASSERT_NEAR(p.sum(), 3.0, 1e-12);
    } else {
      ASSERT_NEAR(p.minCoeff(), 0.0, 1e-12);
    }
  }
  const double root3 = 1.7320508075688772;
  EXPECT_NEAR(on_slope / 20000, root3 / (3 + root3), 0.014);
  EXPECT_LT((mean_on_slope / on_slope - Vector3d(1, 1, 1)).norm(), 0.05);
  EXPECT_EQ(scatter_on_mesh(mesh, 10, 1).positions, scatter_on_mesh(mesh, 10, 1).positions);
  EXPECT_NE(scatter_on_mesh(mesh, 10, 1).positions, scatter_on_mesh(mesh, 10, 2).positions);
}

TEST(Mesh, AllTrueSurfacesAreClosed) {
  const char* folder = std::getenv("ISOTOUCH_DATA");
  if (folder == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA names no folder";
  std::size_t meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(folder) / "meshes")) {
    if (entry.path().extension() != ".ply") continue;
    ++meshes;
    EXPECT_NO_THROW(require_closed(read_mesh(entry.path()), entry.path().string())) << entry.path();
  }
  EXPECT_GE(meshes, 9U);
}

}  // namespace
}  // namespace isotouch::cloud
