#include "host/commands/built_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <future>
#include <utility>
#include <vector>

#include "host/commands/made_field.h"
#include "host/commands/progress_bar.h"
#include "host/encoding/certificate.h"
#include "host/encoding/inside_samples.h"
#include "host/encoding/lost_pieces.h"
#include "host/error.h"
#include "host/field/make_grid.h"
#include "host/field/parallel.h"
#include "host/field/scan_field.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "shared/settings_table.h"

namespace isotouch::commands {

namespace {

/// Of what a device cannot reach or a controller cannot hold.
void warn_of_limits(const FieldView& view, const encoding::SmallComponents& small, const encoding::LostPieces& lost,
                    const BuildOptions& options, BuildReport& report) {
  std::vector<std::string> found = small.warnings();
  for (std::string& warning : lost.warnings(report.placement)) found.push_back(std::move(warning));
  const Eigen::Vector3d origin = to_double(view.origin);
  const double edge = to_double(view.edge);
  const double margin = edge * field::field_margin(options.band_voxels());
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = origin[axis] + margin;
    const double high = origin[axis] + edge * (view.size[static_cast<std::size_t>(axis)] - 1) - margin;
    reach = std::max({reach, -low, high});
  }
  if (reach > cloud::kFalconReach) {
    found.push_back("the object extends " + std::to_string(std::lround(reach)) +
                    " mm from the middle of the workspace, a Falcon reaches about " + std::to_string(std::lround(cloud::kFalconReach)) +
                    " mm; choose a smaller --fit to touch all of it");
  }
  constexpr double kMib = 1 << 20;
  if (static_cast<double>(view.image.size()) > rows::kFieldMib * kMib) {
    found.push_back("the field takes " + std::to_string(std::lround(std::ceil(static_cast<double>(view.image.size()) / kMib))) +
                    " MiB in memory, a controller keeps " + std::to_string(std::lround(rows::kFieldMib)) +
                    " MiB for it unless field_mib says more; choose a larger --voxel or a smaller --grid");
  }
  for (std::string& warning : found) {
    if (!options.quiet) std::fprintf(stderr, "isotouch: %s: %s\n", options.input.string().c_str(), warning.c_str());
    report.warnings.push_back(std::move(warning));
  }
}

/// One sentence with every reason.
std::string refusal(const std::string& input, const std::vector<std::string>& reasons) {
  std::string text = input + ": the field would probably be wrong: ";
  for (const std::string& reason : reasons) text += reason + "; ";
  return text + "--accept-implausible builds it all the same";
}

InputError empty_field(const std::string& input, const BuildReport& report) {
  const std::string better = better_as_mesh(report);
  return InputError(input + ": " + better + (better.empty() ? "" : "; as a cloud: ") + field::kEmptyField);
}

/// The reasons to refuse it; first what is better than to mend the points.
std::vector<std::string> with_better(std::vector<std::string> reasons, const BuildReport& report) {
  const std::string better = better_as_mesh(report);
  if (!reasons.empty() && !better.empty()) reasons.insert(reasons.begin(), better);
  return reasons;
}

}  // namespace

Implausible::Implausible(const std::string& input, BuildReport judged)
    : InputError(refusal(input, judged.verdict->reasons)), report(std::move(judged)) {}

BuiltField built_field(const BuildOptions& options) {
  const field::ThreadLimit limit(options.threads);
  BuildReport report;
  ProgressBar bar(plan_for(SourceKind::kCloud, options.method), options.quiet ? ProgressBar::Drawn::kNever : ProgressBar::Drawn::kAlways);
  field::Progress progress([&](const std::string& stage, double fraction) {
    bar.show()(stage, fraction);
    if (options.on_progress && fraction < 1) options.on_progress(stage, bar.done_now());
  });
  Made made = make_field(options, report, bar, progress);
  if (!options.quiet) {
    for (const std::string& warning : report.warnings)
      std::fprintf(stderr, "isotouch: %s: %s\n", options.input.string().c_str(), warning.c_str());
  }

  if (report.live_verdict) {
    const std::vector<std::string> reasons = with_better(report.live_verdict->reasons(), report);
    if (!reasons.empty() && !options.accept_implausible) throw InputError(refusal(options.input.string(), reasons));
  }
  if (options.method == BuildMethod::kPublished && made.scan) {
    const std::vector<std::string> reasons = with_better(field::reasons_of_scan(*made.scan), report);
    if (!reasons.empty() && !options.accept_implausible) throw InputError(refusal(options.input.string(), reasons));
  }
  // A scan is judged while its image is written; the verdict is the first to be heard.
  const field::BuiltScan built{made.repair ? made.field : field::BandField{}, made.repair.value_or(field::Repair{})};
  const auto policy = options.threads == 1 ? std::launch::deferred : std::launch::async | std::launch::deferred;  // without another thread
  std::future<field::JudgedScan> judged;
  if (made.repair) {
    judged = std::async(policy, [&] {
      const field::ThreadLimit own(options.threads);
      return field::judged_scan(built, *made.scan);
    });
  }
  if (!made.live) progress.begin("image");
  const std::vector<double>& stiffness = made.field.stiffness;
  const double own = stiffness.empty() ? 0.8 : *std::max_element(stiffness.begin(), stiffness.end());
  const Method method = options.method == BuildMethod::kPublished ? Method::kPublished : Method::kDefault;
  const encoding::FieldInfo info{options.stiffness.value_or(own),           report.source_hash, method, options.interpolation,
                                 static_cast<std::uint32_t>(report.points), report.placement};
  encoding::SmallComponents small;
  std::packaged_task<field_file::OpenField()> write(
      [&] { return made.live ? std::move(*made.live) : encoding::write_field(std::move(made.field), info, &small); });
  write();
  std::vector<Eigen::Vector3i> invented;  // cells of bricks
  if (made.repair) {
    progress.begin("verdict");
    auto [verdict, surface] = judged.get();
    report.verdict = std::move(verdict);
    report.verdict->reasons = with_better(std::move(report.verdict->reasons), report);
    invented = std::move(surface.cells);
    if (report.verdict->empty) throw empty_field(options.input.string(), report);
    if (!report.verdict->plausible() && !options.accept_implausible) throw Implausible(options.input.string(), report);
  }
  field_file::OpenField field = write.get_future().get();
  for (const Eigen::Vector3i& cell : invented) field.invented.mark(field.view, 4 * cell.x(), 4 * cell.y(), 4 * cell.z());
  report.inside_nodes = made.inside_nodes.value_or(encoding::inside_samples(field.view));
  if (report.inside_nodes == 0) throw empty_field(options.input.string(), report);
  progress.begin("pack");
  const std::vector<std::uint8_t> packed = field_file::pack(field.view, field.invented);
  progress.begin("write");
  if (!options.out.empty()) write_file(options.out, packed.data(), packed.size());
  progress.end();
  const encoding::LostPieces lost = made.mesh.faces.empty() ? encoding::LostPieces{} : encoding::lost_pieces(made.mesh, field.view);
  warn_of_limits(field.view, small, lost, options, report);
  const double advised = encoding::certificate_of(field.view).stiffness_n_per_mm;
  if (info.stiffness_n_per_mm > advised && !options.quiet) {
    std::fprintf(
        stderr,
        "isotouch: a stiffness of %g N/mm may feed energy into the hand; up to %.3g N/mm is safe with the device that `info` assumes\n",
        info.stiffness_n_per_mm, advised);
  }

  report.packed_bytes = packed.size();
  report.stages = progress.seconds();
  for (const auto& [stage, seconds] : report.stages) report.seconds += seconds;
  BuiltField done{{}, {}, {}, std::move(field), std::move(report)};
  if (made.scan) {
    made.scan->drop_invented();
    if (made.scan->outside != field::Outside::kTurned) {  // else all of them were
      const double bristle = 2 * to_double(done.field.view.edge);
      for (const std::uint32_t i : made.scan->turned) {
        const Eigen::Vector3d& at = made.scan->points.positions[i];
        done.turned.push_back({at, at + bristle * made.scan->points.normals[i]});
      }
    }
    done.points = std::move(made.scan->points);
    done.rim = std::move(made.scan->rim.links);
  } else {
    done.points = std::move(made.live_points);
  }
  return done;
}

}  // namespace isotouch::commands
