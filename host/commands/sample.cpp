/// isotouch sample: a field's distance, gradient and stiffness at any places, as the controller's core computes them.
#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/output.h"
#include "host/cloud/file_kind.h"
#include "host/cloud/ply.h"
#include "host/cloud/xyz.h"
#include "host/commands/commands.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/trace/place_sample.h"

namespace isotouch::commands {

namespace {

using Eigen::Vector3d;

std::vector<Vector3d> read_places(const std::filesystem::path& file) {
  std::vector<std::uint8_t> bytes = read_file(file);
  if (cloud::file_kind(file, bytes) == cloud::FileKind::kPly)
    return cloud::read_ply(file.string(), bytes).positions;  // a row for each point
  return cloud::read_xyz_positions(file.string(), bytes);
}

/// As short as it can be for the number to be read back as it is.
std::string text(double value) { return nlohmann::json(value == 0.0 ? 0.0 : value).dump(); }

/// One line of the answer.
std::string row(const FieldView& field, const Vector3d& place) {
  const trace::PlaceSample sample = trace::sample_place(field, place);
  std::string line;
  for (const double value : {place.x(), place.y(), place.z(), sample.distance_mm, sample.gradient.x(), sample.gradient.y(),
                             sample.gradient.z(), sample.stiffness_n_mm}) {
    line += text(value) + ',';
  }
  return line + (sample.in_band ? "1" : "0") + '\n';
}

struct SampleRun {
  std::filesystem::path field;
  std::filesystem::path points;
  std::filesystem::path out = "-";
  bool input_frame = false;

  void operator()() const {
    const field_file::OpenField open = field_file::open_field(field);
    std::vector<Vector3d> places = read_places(points);
    if (places.empty()) throw InputError(points.string() + ": there are no points in it; give lines of x,y,z");
    if (input_frame) {
      const cloud::Placement placement = evaluate::placement_of(open.view);
      for (Vector3d& place : places) place = placement.to_workspace(place);
      if (!std::all_of(places.begin(), places.end(), [](const Vector3d& place) { return place.allFinite(); }))
        throw InputError(points.string() + ": a point is too far away to have a place in the workspace; leave it out");
    }
    std::string table = "x_mm,y_mm,z_mm,distance_mm,gradient_x,gradient_y,gradient_z,stiffness_n_mm,in_band\n";
    for (const Vector3d& place : places) table += row(open.view, place);
    write_file(out, table);
  }
};

}  // namespace

void add_sample(CLI::App& app) {
  auto run = std::make_shared<SampleRun>();
  CLI::App* command = app.add_subcommand("sample", "Print a field's distance, gradient and stiffness at given points");
  command->add_option("FIELD", run->field, "the field (.itf)")->required();
  command
      ->add_option("POINTS", run->points,
                   "the points: PLY, or text with x,y,z in each line, or with a first line of names; - is standard input")
      ->required();
  add_output(*command, "-o,--out", run->out, {&forms::kTable}, "the table to write, by default to standard output");
  command->add_flag("--input-frame", run->input_frame, "the points are in the scan's coordinates; the answer is always in workspace mm");
  command->callback([run] { (*run)(); });
}

}  // namespace isotouch::commands
