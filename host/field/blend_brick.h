/// The blend of local models at the 64 samples of a brick, four, eight or sixteen at a time.
///
/// The formulas are those of `Surface::distance`, in single precision and relative to the samples. Every lane is rounded by itself, so the
/// vector width of a machine changes the time and not the bits.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/empty_balls.h"
#include "host/field/local_model.h"
#include "host/field/nearest.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

/// Models a blend. Trial of 2026-11: 6 and 10 within 1 %, but 6 leave more shards; 4 leave normals 10 % rougher.
inline constexpr std::size_t kBlended = 8;
/// The share of the largest weight below which a model is left out: that costs below 1/2000 voxel, and saves a quarter of the work.
inline constexpr double kLeastWeight = 1e-4;

class BrickBlend {
 public:
  /// positions, models, balls   of the samples, in one order; coordinates are voxels
  BrickBlend(std::vector<Eigen::Vector3d> positions, const std::vector<LocalModel>& models, const std::vector<EmptyBalls>& balls);

  /// Places that lie far from every sample, one bit each; and those of them where the models see a surface that no sample is near to.
  struct Doubt {
    double beyond = kDoubt.share;  ///< what far is: share of the nearest nine's spread; told to the blend
    std::uint64_t far = 0, suspect = 0;
  };

  /// Signed distances at first + (i, j, k), 0 <= i, j, k < 4, x fastest; within 1e-4 of `Surface::distance`.
  ///
  /// candidates   more than kBlended samples, among them the kBlended + 1 nearest to each of the 64 places
  /// doubt        is told which places are
  std::array<float, 64> operator()(const Eigen::Vector3d& first, std::span<const Neighbour> candidates, Doubt& doubt) const;

  struct Point {
    float x, y, z;
  };
  struct Patch {
    Point point, normal, across, along;
    float gentle, tight;                ///< curvatures
    float gentle_radius, tight_radius;  ///< 1 / curvature, 0 where it is 0
  };
  /// What a sample brings, relative to itself.
  struct Model {
    std::array<Patch, kMaxPieces> pieces;
    std::uint32_t count, concave;
    float reach, trust;
    Point inner, outer;                ///< centres of its empty balls
    float inner_radius, outer_radius;  ///< less their slack
    float body;                        ///< how far from the sample there may be body; only `blend_body_...` asks
  };
  /// What a model is in a blend, without its balls.
  static Model model_of(const Eigen::Vector3d& sample, const LocalModel& model);

 private:
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Model> models_;
};

/// A sample near a brick, relative to the brick's middle.
struct BlendCandidate {
  const BrickBlend::Model* model;
  BrickBlend::Point own;
};

/// What `BrickBlend` does with its candidates: by any machine, by one with vectors of eight numbers (on x86-64: AVX2), and by one with vectors of
/// sixteen (AVX-512). All give the same bits.
std::array<float, 64> blend_by_fours(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt);
std::array<float, 64> blend_by_eights(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt);
std::array<float, 64> blend_by_sixteens(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt);

/// What the candidates near a brick say of its 64 places, and how far that reaches.
struct BrickReading {
  std::array<float, 64> distance{};
  float influence = 0.0F;  ///< squared, from the brick's middle, rounded up: a sample farther away would change none of them
};

/// The same without balls and doubt, of a body that ends where its samples do. To the sides of a sample there is body up to its `body`, straight
/// behind it up to `depth`, and in between up to in between. How far behind a place lies is its blended distance over the nearest sample's, or over
/// reach - depth where that is less. `body` is blended as the distance is, so the result is continuous.
///
/// candidates   any number; all that are among the kBlended + 1 nearest of one of the 64 places and within `reach` of it. More of them change nothing
///              as long as those in common keep their order
/// reach        samples farther away from a place do not count there; `depth` and the band
/// depth        at least every `body`
/// returns      distances; `reach` - `depth` or more where no sample is in reach
BrickReading blend_body(std::span<const BlendCandidate> candidates, float reach, float depth);
BrickReading blend_body_by_fours(std::span<const BlendCandidate> candidates, float reach, float depth);
BrickReading blend_body_by_eights(std::span<const BlendCandidate> candidates, float reach, float depth);
BrickReading blend_body_by_sixteens(std::span<const BlendCandidate> candidates, float reach, float depth);

/// How far the nearest of the candidates is from each of the 64 places.
///
/// candidates   at least one; among them the nearest of every place
BrickReading nearest_distances(std::span<const BlendCandidate> candidates);
BrickReading nearest_distances_by_fours(std::span<const BlendCandidate> candidates);
BrickReading nearest_distances_by_eights(std::span<const BlendCandidate> candidates);
BrickReading nearest_distances_by_sixteens(std::span<const BlendCandidate> candidates);

}  // namespace isotouch::field
