#include "host/encoding/round_creases.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "host/encoding/apron.h"
#include "host/field/parallel.h"
#include "host/field/simd.h"

namespace isotouch::encoding {

namespace {

using namespace field;  // numbers by four

/// The brick itself and those that its samples look into.
constexpr std::size_t kStar[] = {4, 10, 12, 13, 14, 16, 22};

constexpr int kSteps = 12;  // the fillet is at most two voxels wide on each side; a Jacobi step carries one

/// One brick after one step, and whether anything changed. A neighbour beyond the band is NaN, and so is every sum with it: no change.
bool step(const Apron& apron, float sharpest, Samples& samples) {
  bool changed = false;
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      const float* at = &apron[apron_number(0, y, z)];
      const Four here = load(at);
      const Four around = (load(at - 1) + load(at + 1)) + (load(at - 6) + load(at + 6)) + (load(at - 36) + load(at + 36));
      const Four excess = (around - 6.0F * here) + sharpest;
      if (!any(excess < 0.0F)) continue;
      float* out = &samples[sample_number(0, y, z)];
      store(excess < 0.0F ? here + excess / 6.0F : load(out), out);
      changed = true;
    }
  }
  return changed;
}

}  // namespace

field::BandField round_creases(field::BandField field, const std::vector<Neighbours>& around, float sharpest) {
  const auto band = static_cast<float>(field.band);
  std::vector<Samples> now(field.bricks.size());
  field::in_parallel(now.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      std::transform(field.bricks[b].distance.begin(), field.bricks[b].distance.end(), now[b].begin(),
                     [=](float d) { return std::abs(d) <= band ? d : NAN; });
    }
  });
  std::vector<std::uint32_t> active(now.size());
  std::iota(active.begin(), active.end(), 0U);
  std::vector<Samples> next = now;
  std::vector<std::uint8_t> lowered(now.size(), 0);
  for (int turn = 0; turn < kSteps && !active.empty(); ++turn) {
    std::vector<std::uint8_t> changed(active.size(), 0);
    field::in_parallel(active.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t a = begin; a < end; ++a) changed[a] = step(gather(now, around[active[a]]), sharpest, next[active[a]]);
    });
    std::vector<std::uint8_t> wake(now.size(), 0);
    for (std::size_t a = 0; a < active.size(); ++a) {
      if (changed[a] == 0) continue;
      const std::uint32_t b = active[a];
      now[b] = next[b];
      lowered[b] = 1;
      for (const std::size_t n : kStar) {
        if (around[b][n] != kAbsent) wake[around[b][n]] = 1;
      }
    }
    active.clear();
    for (std::uint32_t b = 0; b < wake.size(); ++b) {
      if (wake[b] != 0) active.push_back(b);
    }
  }
  for (std::size_t b = 0; b < now.size(); ++b) {
    if (lowered[b] == 0) continue;
    for (std::size_t n = 0; n < 64; ++n) {
      if (!std::isnan(now[b][n])) field.bricks[b].distance[n] = now[b][n];
    }
  }
  return field;
}

}  // namespace isotouch::encoding
