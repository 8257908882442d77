/// isotouch compare: a blob against the closed mesh of its object.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/cloud/mesh.h"
#include "host/commands/commands.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/open_blob.h"

namespace isotouch::commands {

namespace {

using evaluate::SurfaceError;

struct Options {
  std::filesystem::path blob;
  std::filesystem::path mesh;
  bool floor = false;
  bool json = false;
};

nlohmann::ordered_json to_json(const SurfaceError& error) {
  return {{"rms_mm", error.rms_mm},       {"rms_voxel", error.rms_voxel},           {"p99_voxel", error.p99_voxel},
          {"max_voxel", error.max_voxel}, {"normal_rms_deg", error.normal_rms_deg}, {"lost", error.lost}};
}

void print(const char* name, const SurfaceError& error) {
  std::printf("%-6s rms %.4f mm = %.4f voxel, p99 %.4f, max %.3f voxel, normals rms %.2f°, lost %zu of %zu\n", name, error.rms_mm,
              error.rms_voxel, error.p99_voxel, error.max_voxel, error.normal_rms_deg, error.lost, error.lost + error.points);
}

void run(const Options& options) {
  const evaluate::OpenBlob blob = evaluate::open_blob(options.blob);
  const cloud::TriangleMesh in_cloud = cloud::read_mesh(options.mesh);
  cloud::require_closed(in_cloud, options.mesh.string());
  const cloud::TriangleMesh mesh = evaluate::placed(in_cloud, evaluate::placement_of(blob.view));
  const SurfaceError error = evaluate::compare_with_mesh(blob.view, mesh);

  nlohmann::ordered_json json = to_json(error);
  if (!options.json) print("blob", error);
  if (options.floor) {
    const evaluate::OpenBlob exact = evaluate::floor_of_mesh(blob.view, mesh);
    const SurfaceError floor = evaluate::compare_with_mesh(exact.view, mesh);
    json["floor"] = to_json(floor);
    if (!options.json) print("floor", floor);
  }
  if (options.json) std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Offset of the blob's surface from a closed mesh, at 20,000 points along its normals");
  command->add_option("BLOB", options->blob, "the field (.itf)")->required();
  command->add_option("MESH", options->mesh, "the true surface in the cloud's frame: PLY, OBJ or STL")->required();
  command->add_flag("--floor", options->floor, "the same for the mesh's own exact distances on the blob's grid");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
