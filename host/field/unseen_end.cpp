#include "host/field/unseen_end.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/brick_gradient.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"
#include "host/field/sets.h"
#include "host/field/sign_step.h"
#include "host/field/unseen_share.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// By trial of 2026-11 on vessels of all kinds seen from outside, on complete scans with bores, pockets and teeth, and on 15 real scans.
constexpr std::size_t kAround = 8;  // points that may show a place
constexpr double kItsWay = 0.5;     // cosine: a point whose normal is nearer to the surface's shows it
constexpr double kMissing = 3.0;    // points that the piece would have, had it been seen
constexpr double kAllRound = 0.25;  // middle eigenvalue of the normals' squares: of a tube 0.28 and more, of the two faces of a wall 0.1
constexpr double kAxis = 0.12;      // least eigenvalue: of a tube 0.11 at most, between teeth 0.13 and more
constexpr double kLarge = 20.0;    // missing points: a piece that has more may be seen to its floor's rim, whose normals lie along the axis
constexpr double kLeaning = 0.55;  // length of the mean normal: of a tube 0.54 at most, of a hole in a face 0.62 and more
constexpr double kLooks = 0.5;     // cosine, from a point to the piece's middle, both seen along the tube
constexpr std::size_t kFewest = 8;  // points that look at it

/// Surface that no point shows: of a brick, then of all bricks that hang together.
struct Unshown {
  Vector3i cell;
  std::size_t samples = 0;                 ///< beside the surface
  Vector3d place = Vector3d::Zero();       ///< sum
  std::vector<std::uint32_t> around = {};  ///< points

  void add(const Unshown& other) {
    samples += other.samples;
    place += other.place;
    around.insert(around.end(), other.around.begin(), other.around.end());
  }
  Vector3d middle() const { return place / static_cast<double>(samples); }
};

/// part      of a sample beside the surface in all of it
bool closes_hollow(Unshown& piece, const cloud::OrientedPoints& points, double part) {
  const double missing = static_cast<double>(piece.samples) * part * static_cast<double>(points.size());
  if (missing < kMissing) return false;
  std::sort(piece.around.begin(), piece.around.end());
  piece.around.erase(std::unique(piece.around.begin(), piece.around.end()), piece.around.end());
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero();
  for (const std::uint32_t p : piece.around) {
    squares += points.normals[p] * points.normals[p].transpose();
    sum += points.normals[p];
  }
  const auto count = static_cast<double>(piece.around.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / count);
  if (solver.eigenvalues()[0] > kAxis && missing < kLarge) return false;
  if (solver.eigenvalues()[1] < kAllRound || sum.norm() > kLeaning * count) return false;
  const Vector3d axis = solver.eigenvectors().col(0), middle = piece.middle();
  const auto looking = std::count_if(piece.around.begin(), piece.around.end(), [&](std::uint32_t p) {
    const Vector3d way = middle - points.positions[p], across = way - axis.dot(way) * axis;
    return points.normals[p].dot(across) > kLooks * across.norm();
  });
  return static_cast<std::size_t>(looking) >= kFewest;
}

}  // namespace

UnseenEnd unseen_end(const BandField& field, const Spacings& spacings) {
  const cloud::OrientedPoints& points = spacings.points();
  std::vector<Unshown> bricks(field.bricks.size());
  std::vector<std::size_t> beside(field.bricks.size());
  in_parallel(field.bricks.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found, room;
    for (std::size_t b = begin; b < end; ++b) {
      const Brick& brick = field.bricks[b];
      const BrickMask passed = samples_that(brick.distance, [](Four d) { return magnitude(d) < 0.5F; }) | sign_steps(brick.distance);
      bricks[b].cell = brick.cell;
      for (int s = 0; s < 64; ++s) {
        if ((passed >> s & 1) == 0) continue;
        ++beside[b];
        const Vector3d place = field.grid.position(4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4));
        const Vector3d outward = gradient_at(brick, s).normalized();
        spacings.around(place, 1, found);
        if (found[0].squared_distance <= field.grid.edge * field.grid.edge) continue;
        const auto shows = [&](const Neighbour& n) {
          return points.normals[n.index].dot(outward) > kItsWay &&
                 std::sqrt(n.squared_distance) < kGap * spacings.at(n.index, room) + field.grid.edge;
        };
        if (shows(found[0])) continue;  // nearly always
        spacings.around(place, kAround, found);
        if (std::any_of(found.begin(), found.end(), shows)) continue;
        Unshown& here = bricks[b];
        ++here.samples;
        here.place += place;
        for (const Neighbour& n : found) here.around.push_back(n.index);
      }
    }
  });
  std::size_t all = 0;
  for (const std::size_t count : beside) all += count;
  std::erase_if(bricks, [](const Unshown& b) { return b.samples == 0; });

  // Bricks that touch hang together.
  Sets sets(bricks.size());
  for (std::uint32_t i = 0; i < bricks.size(); ++i) {
    for (int way = 0; way < 13; ++way) {  // of 27 with itself in the middle: those before it
      const Vector3i cell = bricks[i].cell + Vector3i(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1);
      const auto before = std::span(bricks).first(i);
      const auto other = std::lower_bound(before.begin(), before.end(), cell,
                                          [](const Unshown& brick, const Vector3i& c) { return sort_key(brick.cell) < sort_key(c); });
      if (other == before.end() || other->cell != cell) continue;
      const std::uint32_t a = sets.of(i), b = sets.of(static_cast<std::uint32_t>(other - before.begin()));
      if (a != b) sets.join(a, b);
    }
  }
  std::vector<Unshown> pieces(bricks.size());
  for (std::uint32_t i = 0; i < bricks.size(); ++i) pieces[sets.of(i)].add(bricks[i]);
  UnseenEnd result;
  std::size_t closing = 0, largest = 0;
  for (Unshown& piece : pieces) {
    if (piece.samples == 0 || !closes_hollow(piece, points, 1.0 / static_cast<double>(all))) continue;
    closing += piece.samples;
    if (piece.samples <= largest) continue;
    largest = piece.samples;
    result.place = piece.middle();
  }
  if (all > 0) result.share = static_cast<double>(closing) / static_cast<double>(all);
  return result;
}

}  // namespace isotouch::field
