#include "shared/certificate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include "shared/bytes.h"

namespace isotouch {

namespace {

/// From one of 4³ samples of a brick, or bricks of a node, to the next along each axis.
constexpr std::array<std::size_t, 3> kStep = {1, 4, 16};

using namespace image_layout;

/// The header's numbers, in its formats.
struct Stored {
  std::uint32_t slope, wall, stiffness;
  Loop loop;

  explicit Stored(const std::uint8_t* header) {
    const auto field = [header](std::size_t at) { return load_le<std::uint32_t>(header + at); };
    slope = field(kMaxSlopeAt);
    wall = field(kThinnestWallAt);
    stiffness = field(kAdvisedStiffnessAt);
    const auto damping = std::min(field(kAdvisedDampingAt), std::uint32_t{INT32_MAX});
    loop = {field(kAdvisedPeriodAt), Damping::from_raw(static_cast<std::int32_t>(damping)), field(kAdvisedDelayAt)};
  }
};

/// Without a certificate the proxy takes a distance for a free way, and a wall of 2 voxels may not be jumped: 16 fraction bits.
constexpr std::int64_t kSteepest = 2 << kSlopeBits;
constexpr int kGained = kSlopeBits - Distance::kFractionBits;

/// The stiffness may be rounded down, and stand for a damping that was rounded up: one unit either way.
bool stiffness_follows(const Stored& stored) {
  Loop less = stored.loop;
  less.damping = Damping::from_raw(std::max<std::int32_t>(less.damping.raw() - 1, 0));
  const std::int64_t low = std::int64_t{largest_stiffness(less).raw()} - 1, high = std::int64_t{largest_stiffness(stored.loop).raw()} + 1;
  return stored.stiffness >= low && stored.stiffness <= high;
}

/// The largest difference of two neighbouring coefficients within one of the stored bricks, 12 fraction bits: the slope is no smaller.
std::int32_t largest_difference(const FieldView& field) {
  std::int32_t most = 0;
  const std::int16_t* end = field.bricks + std::size_t{field.brick_count} * kSamplesPerBrick;
  for (const std::int16_t* brick = field.bricks + 2 * kSamplesPerBrick; brick != end; brick += kSamplesPerBrick) {
    const auto hear = [&](std::size_t n, std::size_t step) { most = std::max<std::int32_t>(most, std::abs(brick[n + step] - brick[n])); };
    for (std::size_t n = 0; n < 48; ++n) hear(n, 16);
    for (std::size_t layer = 0; layer < kSamplesPerBrick; layer += 16) {
      for (std::size_t n = 0; n < 12; ++n) hear(layer + n, 4);
    }
    for (std::size_t row = 0; row < kSamplesPerBrick; row += 4) {
      for (std::size_t n = 0; n < 3; ++n) hear(row + n, 1);
    }
  }
  return most;
}

/// The largest difference of the numbers on both sides of the face between two bricks, of which `next` follows `brick` on an axis.
std::int32_t largest_step(const std::int16_t* brick, const std::int16_t* next, std::size_t axis) {
  std::int32_t most = 0;
  for (std::size_t n = 0; n < 16; ++n) {
    const std::size_t at = axis == 0 ? 4 * n : axis == 1 ? n / 4 * 16 + n % 4 : n;
    most = std::max<std::int32_t>(most, std::abs(next[at] - brick[at + 3 * kStep[axis]]));
  }
  return most;
}

/// The same of all faces between the bricks of a node, and of those towards the node that follows it on an axis; constant bricks that are the same have no
/// step between them.
std::int32_t largest_step_from(const FieldView& field, std::uint32_t node, std::uint32_t next, std::size_t axis, bool within) {
  const std::uint32_t *own = field.nodes + std::size_t{node} * kBricksPerNode, *theirs = field.nodes + std::size_t{next} * kBricksPerNode;
  std::int32_t most = 0;
  for (std::size_t slot = 0; slot < kBricksPerNode; ++slot) {
    const bool last = (slot / kStep[axis] & 3) == 3;
    if (last == within) continue;
    const std::uint32_t brick = own[slot], after = within ? own[slot + kStep[axis]] : theirs[slot - 3 * kStep[axis]];
    if (brick == after && brick <= kInside) continue;
    most = std::max(most, largest_step(field.bricks + std::size_t{brick} * kSamplesPerBrick,
                                       field.bricks + std::size_t{after} * kSamplesPerBrick, axis));
  }
  return most;
}

/// The largest difference of two numbers on both sides of any face between bricks, constant ones included.
std::int32_t largest_step(const FieldView& field) {
  std::int32_t most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t node = kInside + 1; node < field.node_count; ++node)
      most = std::max(most, largest_step_from(field, node, node, axis, true));
  }
  const auto width = static_cast<std::size_t>(field.root_size[0]), layer = width * static_cast<std::size_t>(field.root_size[1]);
  const std::size_t cells = layer * static_cast<std::size_t>(field.root_size[2]);
  const std::array<std::size_t, 3> step = {1, width, layer}, around = {width, layer, cells};
  for (std::size_t cell = 0; cell < cells; ++cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell % around[axis] + step[axis] >= around[axis]) continue;  // the last on its axis
      const std::uint32_t node = field.root[cell], next = field.root[cell + step[axis]];
      if (node != next || node > kInside) most = std::max(most, largest_step_from(field, node, next, axis, false));
    }
  }
  return most;
}

/// As far as the header alone tells.
bool header_agrees(const Stored& stored, const FieldView& field) {
  if (stored.slope == 0) return true;                                               // no certificate
  const std::int64_t widest = std::int64_t{field.band.raw()} * 2 * (1 << kGained);  // both numbers have 16 fraction bits
  return stiffness_follows(stored) && stored.wall <= widest;
}

/// Does the field rise by no more than this from one number to the next, within its bricks and from one to another? `slope` has 16 fraction bits.
bool rises_at_most(const FieldView& field, std::int64_t slope) {
  return slope >= std::int64_t{std::max(largest_difference(field), largest_step(field))} * (1 << kGained);
}

bool agrees_with_itself(const FieldView& field) {
  const Stored stored(field.image.data());
  return header_agrees(stored, field) && (stored.slope == 0 || rises_at_most(field, stored.slope));
}

CertificateCheck suits(const FieldView& field, const Loop& loop, Stiffness wanted) {
  const Stiffness largest = largest_stiffness(loop);
  const Stiffness rendered = wanted > Stiffness{} ? wanted : field.stiffness;
  if (rendered > largest) return {false, Error::kTooStiff, largest};
  return {true, {}, largest};
}

}  // namespace

Loop assumed_loop(const FieldView& field) { return Stored(field.image.data()).loop; }

Stiffness largest_stiffness(const Loop& loop) {
  if (loop.damping <= Damping{} || loop.period_ns == 0) return {};
  constexpr std::uint64_t kNanosecond = 1'000'000'000;
  constexpr int kSpare = Damping::kFractionBits - Stiffness::kFractionBits;
  const std::uint64_t twice = 2 * static_cast<std::uint64_t>(loop.damping.raw()) * kNanosecond;                             // below 2^62
  const std::uint64_t time = (2 * std::uint64_t{loop.delay_ticks} + 1) * std::min(loop.period_ns, std::uint32_t{1} << 30);  // below 2^64
  return Stiffness::from_raw(saturate32(static_cast<std::int64_t>((twice / time) >> kSpare)));
}

CertificateCheck check_certificate(const FieldView& field, const Loop& loop, Stiffness wanted) {
  if (!agrees_with_itself(field)) return {false, Error::kBadCertificate, {}};
  if (Stored(field.image.data()).slope == 0 && !rises_at_most(field, kSteepest)) return {false, Error::kTooSteep, {}};
  return suits(field, loop, wanted);
}

CertificateCheck check_certificate_header(const FieldView& field, const Loop& loop, Stiffness wanted) {
  if (!header_agrees(Stored(field.image.data()), field)) return {false, Error::kBadCertificate, {}};
  return suits(field, loop, wanted);
}

}  // namespace isotouch
