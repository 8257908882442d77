/// Four numbers at once: vectors of a fixed width, which compilers map to what the machine has. Operators act lane by lane, and every lane is
/// rounded by itself, so the vector width of a machine changes the time and not the bits. The functions are each source's own: sources may be
/// compiled with different ideas of what is no number.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

/// Before a function and all that it calls here: compiled twice, and the machine takes what it understands best, a quarter fewer instructions with
/// AVX2. For gcc on x86-64; clang 14 gives such functions names that other files do not find.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define ISOTOUCH_WIDEST __attribute__((target_clones("avx2", "default"), flatten))
#else
#define ISOTOUCH_WIDEST
#endif

namespace isotouch::field {

using Four = float __attribute__((vector_size(16)));

static inline Four all(float value) { return Four{} + value; }
static inline Four load(const float* from) {
  Four v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
static inline void store(Four v, float* to) { std::memcpy(to, &v, sizeof v); }
static inline Four root(Four v) {
  Four r;
  for (int i = 0; i < 4; ++i) r[i] = std::sqrt(v[i]);
  return r;
}
/// `b` where one of the two is no number.
static inline Four lesser(Four a, Four b) { return a < b ? a : b; }
static inline Four larger(Four a, Four b) { return a > b ? a : b; }
static inline Four magnitude(Four v) { return larger(v, -v); }
static inline float least(Four v) { return std::min(std::min(v[0], v[1]), std::min(v[2], v[3])); }
static inline float largest(Four v) { return std::max(std::max(v[0], v[1]), std::max(v[2], v[3])); }
/// Is any lane of a comparison true, or of a number other than +0?
template <class Vector>
static inline bool any(Vector v) {
  using Halves = std::int64_t __attribute__((vector_size(16)));
  const auto halves = std::bit_cast<Halves>(v);
  return (halves[0] | halves[1]) != 0;
}

}  // namespace isotouch::field
