/// Scans as bad as real ones, of objects whose true surface is known: what the field makes of them, and what it says about itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/oriented_points.h"
#include "host/cloud/shapes.h"
#include "host/field/verdict.h"

namespace isotouch::evaluate {

/// One way to spoil a scan. Lengths are in median spacings, shares of 1.
struct Dirt {
  std::string name;
  double strays = 0;    ///< points added in the box and a tenth of its longest side round it, normals in any direction
  double noise = 0;     ///< standard deviation of every coordinate
  double tilt_deg = 0;  ///< standard deviation of a normal about both axes across it, degrees
  double flipped = 0;   ///< share of the normals turned round
  double thinned = 1;   ///< share that is left of the half with the larger x
  double layer = 0;     ///< half of the points lifted by half of this, the others lowered
  double hole = 0;      ///< radius of a hole, where the surface is farthest along (1, 2, 3)
  bool no_normals = false;
  bool dense = false;  ///< 100,000 points instead of about 4,000
};

/// Clean first.
std::vector<Dirt> all_dirt();

/// A body, wholly scanned or seen from one side.
struct DirtyScan {
  cloud::Shape shape;
  bool one_sided = false;
  std::string name() const { return shape.name + (one_sided ? ", one side" : ""); }
};
/// Each body whole, then each from one side; of our own shapes without others.
std::vector<DirtyScan> dirty_scans(std::vector<cloud::Shape> bodies = {});

/// What a body encloses. Of one whose shape says no volume, the share of places in its box that are inside: to a third of a per cent (one standard
/// deviation) if the body fills a hundredth of the box or more.
double true_volume(const cloud::Shape& shape);

/// What became of a scan.
struct DirtySurface {
  std::string refused;     ///< why nothing was built; empty: a field was built
  double surface_rms = 0;  ///< from the truth to the field's surface, voxels; points without a crossing count 2
  /// From the field's surface to the truth, voxels; 2 where the field has no surface. None for a scan of one side, whose back is invented. A lower
  /// bound if the shape has no exact distances.
  std::optional<double> truth_rms;
  std::size_t pieces = 0;
  std::optional<double> volume;  ///< over the true volume; none for a scan of one side
  double wrong_side =
      0;  ///< share of places two voxels off the scanned surface, not off its holes, that are on the wrong side of the field's

  /// More than 1 % of the scanned side on the wrong side, the volume off by more than 5 %, or no place of the truth near the surface. Pieces that stand
  /// alone are not judged: what strays leave of them is a few voxels large.
  bool wrong() const;
};

struct DirtyRow : DirtySurface {
  std::string scan, dirt;
  field::Verdict verdict;
  std::optional<DirtySurface> beside;  ///< of another program

  /// Wrong, and called plausible: what must never happen.
  bool believed_wrong() const { return refused.empty() && wrong() && verdict.plausible(); }
};

/// Of the scans of which both built a field: how often ours is nearer to the truth than the other program's.
struct Tally {
  std::size_t both = 0, surface = 0;      ///< all of them; in so many ours is nearer from truth to surface
  std::size_t both_whole = 0, truth = 0;  ///< those of all sides; in so many ours is nearer from surface to truth

  void count(const DirtyRow& row);
};

/// Another program: oriented points to a closed mesh in their frame; InputError when it gives none.
using Reconstruct = std::function<cloud::TriangleMesh(const cloud::OrientedPoints&)>;

/// dirt      each gives one row, shown when it is known
/// beside    gets the same points, but for a scan without normals, of which it gets none; its mesh is turned into a field and measured as ours
void dirty_rows(const DirtyScan& scan, std::span<const Dirt> dirt, const std::function<void(const DirtyRow&)>& show,
                const Reconstruct& beside = {}, std::uint64_t seed = 1);

}  // namespace isotouch::evaluate
