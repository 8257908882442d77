/// isotouch scan: touch → points. A recorded trace of positions and forces, or a mesh that a simulated hand strokes first.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/mesh.h"
#include "host/cloud/placement.h"
#include "host/cloud/ply.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/commands.h"
#include "host/commands/progress_bar.h"
#include "host/commands/quantities.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/mesh_scan.h"
#include "host/evaluate/touch_points.h"
#include "host/evaluate/truth_comparison.h"
#include "host/field/closed_mesh.h"
#include "host/field/nearest.h"
#include "host/field/triangle_tree.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct ScanOptions {
  fs::path input;
  fs::path out;
  fs::path trace;
  evaluate::TouchOptions touch;
  evaluate::MeshScanOptions scan;
  bool json = false;
};

/// The trace's header when a simulated hand feels a mesh: of no field, a bare spring.
TraceHeader scan_header(double stiffness) {
  TraceHeader header;
  header.period_ns = evaluate::kScanPeriodNs;
  header.has_outputs = true;
  header.settings.stiffness = to_fixed<Stiffness>(stiffness);
  header.settings.force_limit = to_fixed<Newton>(evaluate::kScanForceLimit);
  header.settings.ramp_ticks = 0;
  return header;
}

evaluate::MeshScanReport record_scan(const field::TriangleTree& tree, const ScanOptions& options) {
  const TraceHeader header = scan_header(options.scan.stiffness_n_per_mm);
  trace::TraceWriter writer(options.trace, header);
  ProgressBar bar({{"strokes", 1}});
  field::Progress progress(bar.show());
  progress.begin("strokes");
  const double ticks = options.scan.seconds / (evaluate::kScanPeriodNs * 1e-9);
  Chain chain(header);
  std::uint64_t tick = 0;
  const auto report = evaluate::scan_mesh(tree, options.scan, [&](const Input& input, const Output& output) {
    writer.append({input, output, chain.extend(input, output), header.period_ns * tick++});
    if (tick % 1024 == 0) progress.report(std::min(0.99, static_cast<double>(tick) / ticks));
  });
  writer.finish();
  progress.end();
  return report;
}

/// The share of the surface that lies within `reach` of a point.
double coverage(const cloud::TriangleMesh& mesh, const cloud::OrientedPoints& points, double reach) {
  constexpr std::size_t kAsked = 20'000;
  const field::Nearest nearest(points.positions);
  std::vector<field::Neighbour> found;
  std::size_t near = 0;
  for (const Eigen::Vector3d& place : cloud::scatter_on_mesh(mesh, kAsked, kAsked).positions) {
    nearest.nearest(place, 1, found);
    near += found[0].squared_distance <= reach * reach ? 1U : 0U;
  }
  return static_cast<double>(near) / kAsked;
}

nlohmann::ordered_json touch_json(const evaluate::TouchReport& report) {
  return {{"ticks", report.ticks},     {"free", report.free},     {"unfit", report.unfit},   {"weak", report.weak},
          {"touches", report.touches}, {"places", report.places}, {"points", report.points}, {"spacing_mm", report.spacing_mm}};
}

void print(const ScanOptions& options, const evaluate::TouchReport& report) {
  std::fprintf(stderr,
               "%zu ticks: %zu free, %zu unfit (ramping, limited, following, stale, no proxy), %zu weak, %zu touches at %zu places\n",
               report.ticks, report.free, report.unfit, report.weak, report.touches, report.places);
  std::fprintf(stderr, "%s: %zu points, about %.3f mm apart\n", options.out.string().c_str(), report.points, report.spacing_mm);
}

void scan_trace(const ScanOptions& options) {
  const auto trace = trace::read_trace(options.input);
  evaluate::TouchReport report;
  const cloud::OrientedPoints points = evaluate::touch_points(trace, options.touch, report);
  cloud::write_ply(options.out, points, "isotouch scan of a trace, workspace mm");
  if (options.json) {
    print_json(touch_json(report));
  } else {
    print(options, report);
  }
}

void scan_mesh(const ScanOptions& options) {
  if (options.trace.empty()) {
    throw InputError(options.input.string() + ": to scan a mesh name the trace to record with --trace");
  }
  cloud::TriangleMesh in_file = cloud::read_mesh(options.input);
  cloud::require_closed(in_file, options.input.string());
  field::MeshRepair none;  // of a closed mesh
  in_file = field::closed_mesh(std::move(in_file), options.input.string(), none);
  const cloud::Placement placement = cloud::place(in_file.vertices);
  const cloud::TriangleMesh mesh = evaluate::true_surface(cloud::placed(in_file, placement)).outer;
  const field::TriangleTree tree(mesh);
  const evaluate::MeshScanReport scan = record_scan(tree, options);

  evaluate::TouchReport report;
  cloud::OrientedPoints points = evaluate::touch_points(trace::read_trace(options.trace), options.touch, report);
  const double covered = coverage(mesh, points, report.spacing_mm);
  for (Eigen::Vector3d& position : points.positions) position = placement.to_cloud(position);
  cloud::write_ply(options.out, points, "isotouch scan of a mesh, in its frame, seed " + std::to_string(options.scan.seed));
  if (options.json) {
    nlohmann::ordered_json json = touch_json(report);
    json["strokes"] = scan.strokes;
    json["deepest_mm"] = scan.deepest_mm;
    json["coverage"] = covered;
    print_json(json);
    return;
  }
  std::fprintf(stderr, "%s: %.1f s in %zu strokes, %zu of %zu targets reached, at most %.2f mm deep\n", options.trace.string().c_str(),
               static_cast<double>(scan.ticks) * evaluate::kScanPeriodNs * 1e-9, scan.strokes, scan.reached, scan.targets, scan.deepest_mm);
  print(options, report);
  std::fprintf(stderr, "coverage: %.2f %% of the surface within %.3f mm of a point\n", 100 * covered, report.spacing_mm);
}

/// Standard input is a mesh where the trace to record is named, as a mesh wants it.
bool is_trace(const ScanOptions& options) {
  const fs::path& file = options.input;
  if (is_standard(file)) return options.trace.empty();
  return file.extension() == ".trace" || nature_of(file) == FileNature::kTrace;
}

}  // namespace

void add_scan(CLI::App& app) {
  auto options = std::make_shared<ScanOptions>();
  CLI::App* command = app.add_subcommand(
      "scan", "Turn touches into oriented points: from a trace with forces, or from a mesh that a simulated hand strokes");
  command->add_option("INPUT", options->input, "a .trace with positions and forces, or a closed mesh: PLY, OBJ or STL")->required();
  add_output(*command, "-o,--out", options->out, {&forms::kPly},
             "the cloud to write, from a mesh in its frame, from a trace in workspace mm")
      ->required();
  command->add_option("--points", options->touch.points, "largest number of points; they are spread evenly")
      ->check(whole_number_in(8, 1000000))
      ->capture_default_str();
  command
      ->add_option("--stiffness", options->touch.stiffness_n_per_mm,
                   "stiffness of the wall that was touched: of a trace that has forces and no proxies; of a mesh, by default 0.8")
      ->transform(quantity(kStiffness, 0.001, 100.0));
  command->add_option("--least-force", options->touch.least_force_n, "leave out touches weaker than this, N")
      ->check(number_in(0.0, 100.0))
      ->capture_default_str();
  add_output(*command, "--trace", options->trace, {&forms::kTrace}, "with a mesh: also write the simulated hand's trace");
  command->add_option("--seconds", options->scan.seconds, "with a mesh: how long the hand strokes it at most, s")
      ->check(number_in(1.0, 3600.0))
      ->capture_default_str();
  command->add_option("--seed", options->scan.seed, "with a mesh: seed of the hand's random numbers")->capture_default_str();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, command] {
    require_apart(options->out, options->json);
    if (is_standard(options->trace)) throw CLI::ValidationError("--trace", "the trace is read again after it was written; name a file");
    const bool from_trace = is_trace(*options);
    if (!from_trace && options->touch.stiffness_n_per_mm > 0)
      options->scan.stiffness_n_per_mm = std::exchange(options->touch.stiffness_n_per_mm, 0);  // the simulated hand has proxies
    for (const char* name : {"--trace", "--seconds", "--seed"}) {
      if (from_trace && command->count(name) > 0)
        throw UsageError(options->input.string() + ": " + name + " is for a hand that strokes a mesh, this is a trace; leave it out");
    }
    from_trace ? scan_trace(*options) : scan_mesh(*options);
  });
}

}  // namespace isotouch::commands
