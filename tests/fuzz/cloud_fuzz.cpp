/// The doors for scans: PLY, OBJ, text, PCD and depth images, by the first byte, and the normals of a grid.
#include "host/cloud/depth_image.h"
#include "host/cloud/obj.h"
#include "host/cloud/pcd.h"
#include "host/cloud/ply.h"
#include "host/cloud/scan_grid.h"
#include "host/cloud/xyz.h"
#include "host/error.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

namespace {

cloud::Model read(std::uint8_t kind, std::span<const std::uint8_t> file) {
  switch (kind % 8) {
    case 0: return cloud::is_bare_ply_mesh(cloud::read_ply_header("a.ply", file)), cloud::read_ply("a.ply", file);
    case 1: return cloud::read_obj_points("a.obj", file);
    case 2: return cloud::read_pcd("a.pcd", file);
    case 3: return cloud::read_depth_image("a.png", file, {.fx = 500, .fy = 500, .cx = 1, .cy = 1});
    default: return cloud::read_xyz("a.xyz", file);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  try {
    cloud::Model model = read(data[0], {data + 1, size - 1});
    for (const auto& p : model.positions) fuzz::hold(p.allFinite(), "a position is finite");
    if (!model.grid || !model.normals.empty()) return 0;
    for (const auto cell : model.grid->cells)
      fuzz::hold(cell == cloud::ScanGrid::kNoReturn || static_cast<std::size_t>(cell) < model.positions.size(),
                 "a cell names a point that is there");
    if (!orient_by_grid(model, *model.grid)) return 0;
    fuzz::hold(model.normals.size() == model.positions.size(), "every point has a normal");
    for (const auto& n : model.normals) fuzz::hold(n.norm() > 0.999 && n.norm() < 1.001, "a normal is of unit length");
  } catch (const InputError&) {  // refused with a sentence
  }
  return 0;
}
