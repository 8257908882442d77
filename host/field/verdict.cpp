#include "host/field/verdict.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <optional>

#include "host/cloud/check.h"
#include "host/field/hull_volume.h"
#include "host/field/parallel.h"
#include "host/field/rounding.h"
#include "host/field/unseen_end.h"
#include "host/field/unseen_share.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Limits, from the table that `isotouch evaluate --dirty` prints: no build there that is wrong passes them.
constexpr double kMostOffSurface = 0.03;
constexpr double kMostOpposed = 0.02;
constexpr double kMostTurned = 0.25;
constexpr double kMostContradicted =
    0.01;  // thin and narrow parts contradict themselves in a sound scan too: there neighbours do not know the side
/// Ten views of one side have 0.03 at most, slats before a wall 0.05, whole bodies 0.23 to 0.37, the two faces of a plate 0.39.
constexpr double kMostHidden = 0.08;
constexpr double kMostStrays = 0.3;
constexpr double kMostNoise = 0.8;  // spacings
constexpr double kMostGaps = 0.01;
constexpr double kMostGapsOfSheet = 0.025;  // what one view sees has shadows
constexpr double kMostUnseenEnds = 0.0002;  // a mouth has as much whose width is 3 % of a ball's
constexpr double kMostUnexplained = 0.4;
constexpr double kMostSurprising = 0.02;
constexpr double kLayered = 0.86;      // of `Roughness::layered`, between noise and walls
constexpr double kLayersApart = 0.03;  // of the noise in spacings: less is the rounding of a file
constexpr double kPerNoise = 2.0;      // of the noise's square: what still surprises after smoothing was worse before
/// Of the strays among the points: one that was not found lies beside the surface; it surprises, and harms little.
constexpr double kPerStray = 0.33;
constexpr double kMostTwice = 0.03;  // 19 real scans and most bodies have 0, an edge with estimated normals 0.009; see entry 174
constexpr double kMostVolume =
    0.08;  // more than the points enclose: areas of samples at edges overlap, so that thin boxes enclose too much: no bound below
constexpr double kLeastOfHull = 0.01;  // a sheet metal part has more
constexpr double kMostOfHull = 1.05;
constexpr double kMostDebris = 0.05;

// Of a rim's mean normal: a hole in a face has 0.4 and more, the open end of a limb or of a plate at most 0.2.
constexpr double kTubeEnd = 0.25;

constexpr double kMostInLines = 0.25;  // lines five times as far apart as the points on them have 0.36 and more, real scans 0.001
constexpr double kMostRounded = 4.5;   // voxels: up to 4.4 seven bodies came out right, at 5.0 one had 1.13 times its volume
constexpr double kAlongAxis = 0.99;    // cosine
constexpr double kAlongAxes = 0.9;     // of the normals: a body of flat faces along the axes may well lie on a lattice
// Of the points: in patches. 19 real clouds have none; a wall seen through a ball's opening is 0.017 of six views together.
constexpr double kMostPatches = 0.005;
constexpr double kRemovable = 0.2;  // of the points: so many patches are the scan itself

// Of the surface: the inside of a cup or of a ball has 0.6 and more, veils of flying pixels have 0.08 at most.
constexpr double kMostUnknownSide = 0.15;
constexpr double kManySparse = 0.01;  // of the points: worth a word

// One voxel within, a sound body is 1 voxel deep, and a wall of 1.5 voxels at most 0.5: its surface bulges between the field's samples. Bowls and
// plates with 1.05 to 1.17 times their volume have shares of 0.96 to 0.997, with 1.045 times 0.82, real scans below 0.09.
constexpr double kThinDepth = 0.55;
constexpr double kMostThin = 0.85;

constexpr double kMostTogether = 2.6;  // sum of the squares of all figures over their limits

constexpr std::size_t kAsked = 20'000;  // points, at most

/// Distances and gradients between the samples of a band field.
class Sampled {
 public:
  explicit Sampled(const BandField& field) : field_(field) {}

  /// Trilinear, in voxels, with its gradient; nothing where a sample is not stored.
  std::optional<std::pair<double, Vector3d>> at(const Vector3d& point) const {
    const Vector3d index = field_.grid.to_index(point);
    const Vector3i low = index.array().floor().cast<int>();
    std::array<double, 8> corner{};
    const Brick* brick = nullptr;
    for (int n = 0; n < 8; ++n) {
      const Vector3i sample = low + Vector3i(n & 1, n >> 1 & 1, n >> 2);
      const Vector3i cell(sample.x() >> 2, sample.y() >> 2, sample.z() >> 2);
      if (brick == nullptr || brick->cell != cell) brick = find(cell);
      if (brick == nullptr) return std::nullopt;
      corner[static_cast<std::size_t>(n)] =
          static_cast<double>(brick->distance[static_cast<std::size_t>(((sample.z() & 3) * 4 + (sample.y() & 3)) * 4 + (sample.x() & 3))]);
    }
    const Vector3d t = index - low.cast<double>();
    double value = 0.0;
    Vector3d gradient = Vector3d::Zero();
    for (int n = 0; n < 8; ++n) {
      const Vector3i at(n & 1, n >> 1 & 1, n >> 2);
      Vector3d weight, slope;
      for (int a = 0; a < 3; ++a) {
        weight[a] = at[a] != 0 ? t[a] : 1.0 - t[a];
        slope[a] = at[a] != 0 ? 1.0 : -1.0;
      }
      const double d = corner[static_cast<std::size_t>(n)];
      value += d * weight.prod();
      gradient +=
          d * Vector3d(slope.x() * weight.y() * weight.z(), weight.x() * slope.y() * weight.z(), weight.x() * weight.y() * slope.z());
    }
    return std::pair(value, gradient);
  }

 private:
  const Brick* find(const Vector3i& cell) const {
    const auto found = std::lower_bound(field_.bricks.begin(), field_.bricks.end(), cell,
                                        [](const Brick& b, const Vector3i& c) { return sort_key(b.cell) < sort_key(c); });
    return found != field_.bricks.end() && found->cell == cell ? &*found : nullptr;
  }

  const BandField& field_;
};

/// Of the whole grid. A brick that is not listed has the sign of the sample before it in its row; before the first is outside.
std::size_t inside_samples(const BandField& field) {
  std::size_t inside = 0;
  const Brick* before = nullptr;
  for (const Brick& brick : field.bricks) {
    if (before != nullptr && before->cell.y() == brick.cell.y() && before->cell.z() == brick.cell.z() && before->distance[3] < 0.0F) {
      inside += 64 * static_cast<std::size_t>(brick.cell.x() - before->cell.x() - 1);
    }
    inside += static_cast<std::size_t>(std::count_if(brick.distance.begin(), brick.distance.end(), [](float d) { return d < 0.0F; }));
    before = &brick;
  }
  return inside;
}

std::string per_cent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %%", share < 0.1 ? 1 : 0, 100.0 * share);
  return text;
}

std::string tenths(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// What to do if not all of the points were seen from the sensor's place.
std::string other_sensor(const SoundScan& sound) {
  switch (sound.sensor_from) {
    case SensorFrom::kPerson: break;
    case SensorFrom::kFile: return "ignore the file's line VIEWPOINT with --no-viewpoint";
    case SensorFrom::kAssumption: return "say with --viewpoint where the sensor stood";
    case SensorFrom::kDepthImage: return "set its pixels to 0";
  }
  return "leave out --viewpoint";
}

constexpr const char* kSparseSide =
    " points form a surface that is much sparser than the one on the other side of its wall; scan more densely there, or thin out the rest";

/// What may explain all the reasons that there are.
///
/// along_axis   the voxels of `SoundScan::coarsest`; 0 where no rounding has to be named
std::vector<std::string> explanations(const SoundScan& sound, double along_axis) {
  if (sound.sensor_from == SensorFrom::kDepthImage)
    return {"if the depth image shows more than the object, such as a wall behind it, set pixels that are not the object to 0"};
  std::vector<std::string> list;
  if (along_axis > kMostRoundedOfEstimated) {
    list.push_back(std::string("the coordinates along ") + "xyz"[sound.coarsest.axis] + " come in steps of " + tenths(along_axis) +
                   " voxels; if they are rounded, save the scan with more digits");
  }
  if (sound.is_sheet && sound.is_on_table)
    list.emplace_back("the scan ends at the edge of a flat part; if that is a table or a wall, remove it");
  if (static_cast<double>(sound.sparse) > kManySparse * static_cast<double>(sound.measured))
    list.push_back(std::to_string(sound.sparse) + kSparseSide);
  if (sound.outside == Outside::kViewpoint)
    list.push_back("every normal was turned towards the sensor's place; if not all of the points were seen from there, " +
                   other_sensor(sound) + ", or save the scan with outward normals");
  return list;
}

}  // namespace

std::vector<std::string> reasons_of_scan(const SoundScan& sound) {
  std::vector<std::string> reasons;
  if (sound.is_on_table && !sound.is_sheet) {
    reasons.emplace_back(
        "the scan ends at the edge of a flat part, such as a table on which the object stands; remove the table, or scan what is missing");
  } else if (sound.outside == Outside::kDoubtful) {
    reasons.emplace_back(sound.is_estimated
                             ? "nobody knows which side of the points is outside; save the scan with outward normals, or try --viewpoint"
                             : "the normals do not agree on which side is outside; save the scan with outward normals, or try --normals "
                               "estimate or --viewpoint");
  }
  if (sound.hidden > kMostHidden) {
    reasons.push_back(per_cent(sound.hidden) +
                      " of the points lie behind others as seen from the sensor's place; leave out what was not seen from there, or " +
                      other_sensor(sound));
  }
  return reasons;
}

namespace {

/// Was a finer grid asked for than the points would have got?
bool is_finer_than_usual(const BandField& field, const SoundScan& sound, const std::vector<Vector3d>& measured) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : measured) box.extend(point);
  const Vector3d sides = box.sizes();
  return field.grid.edge < 0.99 * sides.maxCoeff() / sound.usual_grid(sides);
}

}  // namespace

Verdict judge(const BandField& field, const SoundScan& sound, const Repair& repair, const Spacings& spacings) {
  const double volume = static_cast<double>(inside_samples(field)) * field.grid.edge * field.grid.edge * field.grid.edge;
  Verdict verdict;
  verdict.empty = volume == 0.0;
  const std::vector<Vector3d> measured(sound.points.positions.begin(),
                                       sound.points.positions.begin() + static_cast<std::ptrdiff_t>(sound.measured));
  const bool closed = !sound.is_sheet;
  const auto count = static_cast<double>(sound.measured);
  verdict.noise_spacing = sound.spacing > 0.0 ? sound.noise / sound.spacing : 0.0;
  verdict.stray_share = static_cast<double>(sound.strays + repair.isolated) / (count + static_cast<double>(sound.strays));
  verdict.turned_share = static_cast<double>(sound.turned.size() + repair.turned) / count;
  verdict.contradicted_share = sound.contradicted;
  verdict.rim_mm = sound.rim.length;
  verdict.unexplained_share = repair.unexplained;
  verdict.debris_share = static_cast<double>(repair.debris.pieces + repair.debris.cavities) / count;
  const double hull = hull_volume(sound.points.positions);  // with what was invented: a sheet alone has none
  verdict.volume_of_hull = hull > 0.0 ? volume / hull : 0.0;
  // Where a sheet ends beside a shadow, what lies behind its edge was invented, and there is much of it in a sound scan of one side.
  verdict.gap_share = unseen_share(field, spacings, kGap, closed ? Showing::kSameSide : Showing::kAny);
  const UnseenEnd unseen = closed ? unseen_end(field, spacings) : UnseenEnd{};
  verdict.unseen_end_share = unseen.share;
  verdict.surprising_share = repair.surprising;

  if (closed && sound.enclosed > 0.0) verdict.volume_of_enclosed = volume / sound.enclosed;

  const Sampled sampled(field);
  const double slack = 1.0 + 2.0 * sound.noise / field.grid.edge;  // voxels
  const std::size_t step = std::max<std::size_t>(1, measured.size() / kAsked);
  const std::size_t asked = (measured.size() + step - 1) / step;
  std::atomic<std::size_t> off{0}, opposed{0}, thin{0};
  in_parallel(asked, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = step * begin; i < step * end && i < measured.size(); i += step) {
      const auto here = sampled.at(measured[i]);
      if (!here || std::abs(here->first) > slack) {
        ++off;
      } else if (here->second.dot(sound.points.normals[i]) < 0.0) {
        ++opposed;
      }
      const auto within = sampled.at(measured[i] - field.grid.edge * sound.points.normals[i]);
      if (within && within->first > -kThinDepth) ++thin;
    }
  });
  verdict.off_surface_share = static_cast<double>(off) / static_cast<double>(asked);
  verdict.thin_share = static_cast<double>(thin) / static_cast<double>(asked);
  // What the neighbours turned round lies with them now.
  verdict.opposed_share =
      std::max(0.0, static_cast<double>(opposed) / static_cast<double>(asked) - static_cast<double>(repair.turned) / count);

  const auto refuse = [&](bool wrong, const std::string& sentence) {
    if (wrong) verdict.reasons.push_back(sentence);
  };
  // What is wrong shows in several figures; each may be within its limit.
  double together = 0.0, nearest = 0.0;
  std::string above_all;
  const auto limit = [&](double figure, double most, const std::string& sentence) {
    refuse(figure > most, sentence);
    const double of_limit = most > 0.0 ? std::max(0.0, figure) / most : 0.0;  // much noise leaves nothing to be surprised at
    together += of_limit * of_limit;
    if (of_limit <= nearest) return;
    nearest = of_limit;
    above_all = sentence;
  };
  const double most_gaps = closed ? kMostGaps : kMostGapsOfSheet;
  const std::string again = sound.is_estimated ? "save the scan with outward normals, or scan more densely"
                                               : "estimate the normals again, or try --normals estimate";
  // What explains others stands before them: how the scan was made, then what is missing in it, then its normals, then what came of it.
  limit(repair.twice_enclosed, kMostTwice,
        per_cent(repair.twice_enclosed) +
            " of the surface lies within another layer of the scan; align the scans that were merged, or remove one of the layers");
  refuse(sound.layered > kLayered && verdict.noise_spacing > kLayersApart,
         "the points lie in two layers so close to each other that, without normals, nobody knows whether they are the two sides of a thin "
         "wall or scans that do not fit; align the scans that were merged, save the scan with outward normals, or scan more densely");
  const double rounded = sound.rounding / field.grid.edge;
  const auto along_axis = [](const Vector3d& normal) { return normal.cwiseAbs().maxCoeff() > kAlongAxis; };
  const auto straight = std::count_if(sound.points.normals.begin(), sound.points.normals.end(), along_axis);
  const double most_rounded = sound.is_estimated ? kMostRoundedOfEstimated : kMostRounded;
  const bool may_be_rounded = static_cast<double>(straight) < kAlongAxes * static_cast<double>(sound.points.size());
  refuse(rounded > most_rounded && may_be_rounded, "the coordinates are rounded to steps of " + tenths(rounded) +
                                                       " voxels; save the scan with more digits, or choose a coarser --voxel");
  const double far = sound.float_step / field.grid.edge;
  refuse(far > most_rounded, floats_too_coarse(far));
  for (const std::string& reason : reasons_of_scan(sound)) refuse(true, reason);
  refuse(verdict.noise_spacing > kMostNoise,
         "the points scatter by " + per_cent(verdict.noise_spacing) + " of their spacing; smooth the scan, or scan again");
  refuse(
      sound.in_lines > kMostInLines,
      "the points lie in lines that are far apart, and without normals nobody knows the surface between them; save the scan with outward "
      "normals, or scan more lines");
  refuse(sound.unknown_side > kMostUnknownSide,
         "points that were left out form a surface that is much sparser than the one beside it, and without normals nobody knows on "
         "which side of a wall it lies; scan more densely there, thin out the rest, or save the scan with outward normals");
  refuse(verdict.stray_share > kMostStrays, per_cent(verdict.stray_share) + " of the points are strays; remove them from the scan");
  limit(verdict.gap_share, most_gaps,
        per_cent(verdict.gap_share) +
            " of the surface closes gaps that nobody scanned; scan the missing parts, or remove points within the body");
  refuse(closed && sound.rim.samples > 0 && sound.rim.least_surrounded < kTubeEnd,
         "a limb or a wall is cut off in the scan near " + cloud::in_brackets(sound.rim.least_place) +
             ", and nobody knows how far the body goes on; scan the missing part, or cut the scan off in one plane");
  const double patches = static_cast<double>(sound.rim.patches) / count;
  refuse(closed && patches > kMostPatches, per_cent(patches) +
                                               " of the points form patches that nothing joins to the rest, and nobody knows what lies "
                                               "behind them; scan what surrounds them" +
                                               (patches > kRemovable ? "" : ", or remove them"));
  refuse(closed && verdict.thin_share > kMostThin,
         per_cent(verdict.thin_share) +
             " of the surface belongs to walls thinner than two voxels, which come out too thick; choose a finer --voxel");
  limit(verdict.opposed_share, kMostOpposed, per_cent(verdict.opposed_share) + " of the normals point against the surface; " + again);
  refuse(sound.outside == Outside::kNeighbours && verdict.contradicted_share > kMostContradicted,
         "the side of the normals was decided by neighbours, which is not reliable in thin or narrow parts; save the scan with outward "
         "normals, or scan more densely");
  // A scan that was turned as a whole is one decision: what counts then is what was not turned with it.
  const bool as_whole = sound.outside == Outside::kTurned || sound.outside == Outside::kViewpoint;
  const double singly_turned = as_whole ? std::min(verdict.turned_share, 1.0 - verdict.turned_share) : verdict.turned_share;
  refuse(sound.outside != Outside::kNeighbours && singly_turned > kMostTurned,
         per_cent(singly_turned) + " of the normals had to be turned; " + again);
  limit(verdict.off_surface_share, kMostOffSurface,
        per_cent(verdict.off_surface_share) + " of the points lie off the surface; remove strays, or choose a finer --voxel");
  limit(verdict.unexplained_share, kMostUnexplained,
        "no smooth surface explains " + per_cent(verdict.unexplained_share) +
            " of the points; estimate the normals again, or scan again with less noise");
  const double in_noise = std::max(0.0, 1.0 - kPerNoise * verdict.noise_spacing * verdict.noise_spacing);
  // Without normals a part that is too sparse to be known looks like strays, too.
  const std::size_t strays = sound.is_estimated ? 0 : sound.strays_among + repair.isolated;
  const double strays_among = static_cast<double>(strays) / (count + static_cast<double>(sound.strays_among));
  limit(verdict.surprising_share, kMostSurprising * in_noise + kPerStray * strays_among,
        per_cent(verdict.surprising_share) + " of the surface has points where their neighbours do not expect them; " +
            (is_finer_than_usual(field, sound, measured) ? "leave out --voxel and --grid or choose a coarser one, " : "") +
            (sound.strays + repair.isolated > 0 ? "remove strays, " : "") + "scan more densely, or with less noise");
  const double beyond = verdict.gap_share > most_gaps ? 0.0 : verdict.volume_of_enclosed - 1.0;  // known as far as the points close
  limit(beyond, kMostVolume,
        "the body has " + per_cent(verdict.volume_of_enclosed) +
            " of the volume that the points enclose; check the normals and scan missing parts");
  refuse(verdict.volume_of_hull < kLeastOfHull, "the body has hardly any volume; check the normals");
  refuse(closed && verdict.volume_of_hull > kMostOfHull, "the body is larger than the hull of its points; check the normals");
  const std::size_t removed = repair.debris.pieces + repair.debris.cavities;
  limit(verdict.debris_share, kMostDebris,
        std::to_string(removed) + (removed == 1 ? " piece or cavity" : " pieces and cavities") +
            " that no points support had to be removed; check the normals and remove strays");
  refuse(verdict.gap_share <= most_gaps && verdict.unseen_end_share > kMostUnseenEnds,
         "the scan sees into a hollow but not to its end near " + cloud::in_brackets(unseen.place.array().round().matrix()) +
             " mm in the workspace, and nobody knows how large it is; scan its inside, too, or more densely, or cover its mouth and scan "
             "again");
  refuse(verdict.reasons.empty() && together > kMostTogether, "several figures are near their limits, above all this: " + above_all);
  if (!verdict.plausible()) {
    const bool is_named = rounded > most_rounded || far > most_rounded;
    const std::vector<std::string> first = explanations(sound, is_named || !may_be_rounded ? 0.0 : sound.coarsest.step / field.grid.edge);
    verdict.reasons.insert(verdict.reasons.begin(), first.begin(), first.end());
  }
  return verdict;
}

}  // namespace isotouch::field
