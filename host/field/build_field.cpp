#include "host/field/build_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/field/adaptive_samples.h"
#include "host/field/brick_stiffness.h"
#include "host/field/bricks.h"
#include "host/field/hole_samples.h"
#include "host/field/parallel.h"
#include "host/field/surface.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kWitnesses = 4;      // neighbours whose models say where a sample should lie
constexpr double kNoisy = 0.1;             // of the distance to the sixth neighbour: beyond, noise reaches the models
constexpr double kBehind = 1.5;            // spacings: near the samples the winding number is not sharp
constexpr double kTwice = 1.3;             // in a body it is 1
constexpr std::size_t kAskedTwice = 4000;  // samples, about
constexpr double kExplains = 1.5;          // trust of a model: below, its error is above two thirds of a radian

cloud::OrientedPoints in_voxels(const cloud::OrientedPoints& points, const Grid& grid) {
  cloud::OrientedPoints result = points;
  for (auto& p : result.positions) p = grid.to_index(p);
  return result;
}

Box box_of(const std::vector<Eigen::Vector3d>& positions) {
  Box box{positions.front(), positions.front()};
  for (const auto& p : positions) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

/// What the models say of one sample and its neighbours.
struct Witness {
  bool asked = false;  ///< it was measured
  bool unexplained = false, surprising = false;
};

/// How well the models of the measured samples explain their neighbours. Where samples are far apart each stands for more of the surface.
void describe(const AdaptiveSamples& described, std::size_t measured, Repair& repair) {
  const Scan& scan = *described.scan;
  std::vector<Witness> witnesses(scan.size());
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) {
      if (described.point[i] >= measured) continue;
      double sum = 0.0;
      const auto near = scan.around(i, kWitnesses + 1);
      for (const Neighbour& n : near) {
        if (n.index != i) sum += described.models[n.index].distance(scan.positions()[i]);
      }
      witnesses[i] = {true, described.models[i].trust<kExplains, std::abs(sum)> static_cast<double>(near.size() - 1)};
    }
  });
  double asked = 0.0, unexplained = 0.0, area = 0.0, surprising = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!witnesses[i].asked) continue;
    const double stands_for = scan.spacing(i) * scan.spacing(i);
    asked += 1.0;
    unexplained += witnesses[i].unexplained ? 1.0 : 0.0;
    area += stands_for;
    surprising += witnesses[i].surprising ? stands_for : 0.0;
  }
  if (asked > 0.0) repair.unexplained = unexplained / asked;
  if (area > 0.0) repair.surprising = surprising / area;
}

/// Which share of the measured surface has another layer round it? Behind it the points enclose a place twice.
double twice_enclosed(const AdaptiveSamples& described, std::size_t measured, const WindingSign& enclosure) {
  const Scan& scan = *described.scan;
  const std::size_t step = std::max<std::size_t>(1, scan.size() / kAskedTwice);
  std::vector<std::array<double, 2>> answers((scan.size() + step - 1) / step, {0.0, 0.0});
  in_parallel(answers.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t i = n * step;
      if (described.point[i] >= measured) continue;
      const double spacing = scan.spacing(i);
      const bool twice = enclosure(scan.positions()[i] - kBehind * spacing * scan.normals()[i]) > kTwice;
      answers[n] = {spacing * spacing, twice ? spacing * spacing : 0.0};
    }
  });
  double area = 0.0, layered = 0.0;
  for (const auto& [asked, twice] : answers) {
    area += asked;
    layered += twice;
  }
  return area > 0.0 ? layered / area : 0.0;
}

/// The samples with others that were added to them; the models of those there were stay as they are.
AdaptiveSamples with_added(const AdaptiveSamples& described, const cloud::OrientedPoints& added) {
  const Scan& scan = *described.scan;
  cloud::OrientedPoints all{scan.positions(), scan.normals(), scan.stiffness()};
  all.append(added);
  AdaptiveSamples result;
  result.models = described.models;
  result.models.resize(all.size());
  std::vector<std::uint8_t> known(all.size(), 0);
  result.scan = std::make_unique<Scan>(std::move(all));
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const auto heard = result.scan->around(i, kModelled);
    known[i] = std::all_of(heard.begin(), heard.end(), [&](const Neighbour& n) { return n.index < scan.size(); }) ? 1 : 0;
  }
  fit_models(*result.scan, known, result.models);
  return result;
}

}  // namespace

std::vector<std::string> Repair::warnings() const {
  const auto times = [](std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
  };
  std::vector<std::string> list;
  if (isolated > 0) list.push_back(times(isolated, "point", "points") + " too far from others to know a surface there left out");
  if (turned > 0) list.push_back(times(turned, "normal was", "normals were") + " turned because nearly all neighbours contradict");
  if (debris.pieces > 0) list.push_back(times(debris.pieces, "piece", "pieces") + " of surface that no points support left out");
  if (debris.cavities > 0) list.push_back(times(debris.cavities, "cavity", "cavities") + " that no points support filled");
  return list;
}

BandField build_field(const cloud::OrientedPoints& points, const Grid& grid, double band, Progress& progress, Repair* repair,
                      const Origin& origin) {
  if (points.size() < 8) throw InputError("a surface needs at least 8 oriented points, the cloud has " + std::to_string(points.size()));
  cloud::OrientedPoints samples = in_voxels(points, grid);
  const Box tight = box_of(samples.positions);
  const double margin = std::min(tight.low.minCoeff(), (grid.size.cast<double>() - Eigen::Vector3d::Ones() - tight.high).minCoeff());
  if (margin < band + 3.0 - 1e-9) throw InputError("the grid leaves less than band + 3 voxels round the points; choose a larger grid");

  progress.begin("local models");
  AdaptiveSamples described = adaptive_samples(std::move(samples));
  Repair mended;
  mended.isolated = described.isolated;
  mended.turned = described.turned;
  describe(described, origin.measured, mended);

  progress.begin("surface");
  // A scan that is open at a cut goes on along its own direction; the box closes it.
  const double bulge = std::min(kBulge, margin - band - 2.0);
  const Box closing{tight.low.array() - bulge, tight.high.array() + bulge};
  const bool whole = !origin.is_sheet;  // the walls and the back of a scan of one side are invented, and so is what they enclose
  const double noise_voxels =
      whole && origin.noise > kNoisy * grid.edge * described.scan->median_spacing() ? origin.noise / grid.edge : 0.0;
  std::optional<Surface> model(std::in_place, *described.scan, described.models, closing, noise_voxels, whole ? kDoubt : kDoubtOfSheet);
  AdaptiveSamples closed;
  if (whole) {  // a scan of one side got walls at its rims already
    if (const cloud::OrientedPoints skins = hole_samples(*described.scan, *model); skins.size() > 0) {
      closed = with_added(described, skins);
      model.emplace(*closed.scan, closed.models, closing, noise_voxels);
    }
  }
  const Scan& scan = closed.scan ? *closed.scan : *described.scan;
  const Surface& surface = *model;

  if (whole) mended.twice_enclosed = twice_enclosed(described, origin.measured, surface.enclosure());

  progress.begin("bricks");
  const SampledDistance distance{
      [&](const Eigen::Vector3d& x) { return surface.distance(x); },
      [&](const Eigen::Vector3i& cell, double reach) { return surface.brick(4.0 * cell.cast<double>(), reach); }};
  std::vector<Eigen::Vector3i> seeds;
  seeds.reserve(scan.size());
  for (const auto& p : scan.positions()) seeds.emplace_back((p * 0.25).array().floor().cast<int>());
  BandField field{grid, band, {}};
  field.bricks = band_bricks(distance, (grid.size + Eigen::Vector3i::Constant(3)) / 4, band, seeds);
  mended.debris = drop_unsupported(field, scan.positions(), [&](const Eigen::Vector3d& x) { return surface.enclosure()(x) > 0.5; });
  if (field.bricks.empty()) throw InputError("the points do not enclose a body");
  if (!scan.stiffness().empty()) field.stiffness = brick_stiffness(field.bricks, scan.stiffness(), scan.tree());
  progress.end();
  if (repair != nullptr) *repair = mended;
  return field;
}

}  // namespace isotouch::field
