/// A field that changes while it is felt: points come, go and move in batches, and only what they can change is computed again.
///
/// The value at every place depends on the points near it and on nothing else: no winding number, no vote of all normals, no connected parts. So
/// the field is a function of the points that are present, in whatever order they came, and the same as one build from all of them, to
/// the byte:
///
/// 1. Points are integers. Those of one cell of 2³ voxels whose normals look the same way are one sample, the rounded mean (bucket.h).
/// 2. Each sample with enough neighbours gets a local model from the nearest of them (host/field/local_model.h).
/// 3. The value at a place is a blend of the models of the samples nearest to it, and the body ends where its samples do (brick_value.h).
/// 4. Slope and wall of the certificate belong to a brick and to those around it.
///
/// Each of the last three steps knows how far away a sample may be and still matter; a batch makes dirty what its samples, as they were and as they
/// are now, can reach.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/field/band_field.h"
#include "host/field_file/image.h"
#include "host/live/bucket.h"
#include "host/live/live_model.h"
#include "host/live/nodes.h"
#include "host/live/point.h"
#include "host/live/verdict.h"

namespace isotouch::live {

struct Batch {
  std::vector<Point> added;
  std::vector<Point> removed;  ///< each was added before, in this batch or in an earlier one; a point that moves is removed and added
};

/// What a batch made necessary.
struct Work {
  std::size_t samples = 0;  ///< changed, came or went
  std::size_t models = 0;   ///< fitted
  std::size_t bricks = 0;   ///< computed
  std::size_t changed = 0;  ///< bricks whose values became others
};

/// Voxels between the points and the border of the grid, at least, that leave room for the body that reaches beyond them.
constexpr double margin(double band) { return Reach(band).blend + 3.0; }

class LiveField {
 public:
  /// grid      as `field::make_grid` gives it; it stays
  /// band      half width, voxels, 1 to 7.99
  /// fails     InputError when these do not fit the format
  LiveField(const field::Grid& grid, double band, const encoding::FieldInfo& info);

  /// Takes a batch in. Uses as many threads as `field::ThreadLimit` says; the result does not depend on it.
  ///
  /// fails     InputError when a removed point is not there; then the field is of no use any more
  Work apply(const Batch& batch);

  const field::Grid& grid() const { return grid_; }
  const Verdict& verdict() const { return verdict_; }
  /// The sum of the hashes of its points.
  std::uint64_t source_hash() const { return source_hash_; }

  /// Of slope and wall of every brick: the image has only the largest and the least of them, which would hide that others are out of date.
  std::uint64_t certificate_hash() const;

  /// The image (shared/SPEC.md, section 2): trilinear. Its time grows with the field: it is
  /// copied, and its checksum covers all of it.
  field_file::Image image() const;

 private:
  struct Sample {
    Bucket bucket;
    bool touched = false;  ///< in the batch that is being taken in
    bool unexplained = false;
    LiveModel live;
  };
  struct Dirt;

  void take_point(const Point& point, bool removed, Dirt& dirt);
  void take_means(Dirt& dirt);
  void find_models(Dirt& dirt);
  void fit_models(Dirt& dirt);
  void count(const Entry& entry, bool present);
  void find_bricks(const Dirt& dirt);
  Work compute_bricks();
  void certify();

  field::Grid grid_;
  Reach reach_;
  encoding::FieldInfo info_;
  Nodes nodes_;
  std::deque<Sample> samples_;  ///< by slot; they stay where they are
  std::vector<std::uint32_t> free_;
  std::uint64_t source_hash_ = 0;
  Verdict verdict_;
};

}  // namespace isotouch::live
