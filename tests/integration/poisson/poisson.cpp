/// Oriented points → a mesh by screened Poisson reconstruction, to compare with: poisson POINTS.ply MESH.ply
///
/// source    M. Kazhdan and H. Hoppe, "Screened Poisson Surface Reconstruction", ACM Transactions on Graphics 32(3), 2013; the authors' program, as
///           Open3D carries it, with Open3D's settings: depth 8, point weight 4
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>
#include <open3d/io/PointCloudIO.h>
#include <open3d/io/TriangleMeshIO.h>

#include <cstdio>
#include <memory>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: poisson POINTS.ply MESH.ply\n");
    return 2;
  }
  open3d::geometry::PointCloud points;
  if (!open3d::io::ReadPointCloud(argv[1], points) || !points.HasNormals()) {
    std::fprintf(stderr, "%s: no points with normals\n", argv[1]);
    return 1;
  }
  const auto mesh = std::get<0>(open3d::geometry::TriangleMesh::CreateFromPointCloudPoisson(points));
  return open3d::io::WriteTriangleMesh(argv[2], *mesh) ? 0 : 1;
}
