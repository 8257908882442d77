/// Some numbers at once: vectors of a fixed width, which compilers map to what the machine has. Operators act lane by lane, and every
/// lane is rounded by itself, so the vector width of a machine changes the time and not the bits. The functions are each source's own: sources
/// may be compiled with different ideas of what is no number.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace isotouch::field {

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));
using Sixteen = float __attribute__((vector_size(64)));
/// What the machine does at once that a source is compiled for.
#if defined(__AVX512DQ__)
using Lanes = Sixteen;
#elif defined(__AVX2__)
using Lanes = Eight;
#else
using Lanes = Four;
#endif

template <class Vector = Four>
static inline Vector load(const float* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class Vector>
static inline void store(Vector v, float* to) {
  std::memcpy(to, &v, sizeof v);
}
template <class Vector = Four>
static inline Vector all(float value) {
  return Vector{} + value;
}
template <class Vector>
static inline Vector root(Vector v) {
  Vector r;
  for (std::size_t i = 0; i < sizeof v / sizeof v[0]; ++i) r[i] = std::sqrt(v[i]);
  return r;
}
/// `b` where one of the two is no number.
template <class Vector>
static inline Vector lesser(Vector a, Vector b) {
  return a < b ? a : b;
}
template <class Vector>
static inline Vector larger(Vector a, Vector b) {
  return a > b ? a : b;
}
template <class Vector>
static inline Vector magnitude(Vector v) {
  return larger(v, -v);
}
template <class Vector>
static inline float least(Vector v) {
  if constexpr (sizeof v > sizeof(Four)) {  // by halves: lane after lane, each would wait for the one before
    using Half = std::conditional_t<sizeof v == sizeof(Sixteen), Eight, Four>;
    const auto [low, high] = std::bit_cast<std::array<Half, 2>>(v);
    return least<Half>(lesser(low, high));
  } else {
    float value = v[0];
    for (std::size_t i = 1; i < sizeof v / sizeof v[0]; ++i) value = std::min(value, v[i]);
    return value;
  }
}
template <class Vector>
static inline float largest(Vector v) {
  return -least(-v);
}
/// Is any lane of a comparison true?
template <class Vector>
static inline bool any(Vector v) {
#ifdef __AVX512DQ__
  using Numbers = int __attribute__((vector_size(64)));
  if constexpr (sizeof v == 64) return __builtin_ia32_cvtd2mask512(std::bit_cast<Numbers>(v)) != 0;
#endif
#ifdef __AVX__
  if constexpr (sizeof v == 32) return __builtin_ia32_movmskps256(std::bit_cast<Eight>(v)) != 0;
#endif
#ifdef __SSE2__
  if constexpr (sizeof v == 16) return __builtin_ia32_movmskps(std::bit_cast<Four>(v)) != 0;
#endif
  std::uint64_t bits = 0;
  for (const std::uint64_t part : std::bit_cast<std::array<std::uint64_t, sizeof v / 8>>(v)) bits |= part;
  return bits != 0;
}
/// The lanes of a comparison that are true, the first in the lowest bit.
template <class Vector>
static inline unsigned true_lanes(Vector v) {
#ifdef __AVX512DQ__
  using Numbers = int __attribute__((vector_size(64)));
  if constexpr (sizeof v == 64) return static_cast<std::uint16_t>(__builtin_ia32_cvtd2mask512(std::bit_cast<Numbers>(v)));
#endif
#ifdef __AVX__
  if constexpr (sizeof v == 32) return static_cast<unsigned>(__builtin_ia32_movmskps256(std::bit_cast<Eight>(v)));
#endif
#ifdef __SSE2__
  if constexpr (sizeof v == 16) return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Four>(v)));
#endif
  unsigned bits = 0;
  for (std::size_t i = 0; i < sizeof v / sizeof v[0]; ++i) bits |= (v[i] != 0 ? 1U : 0U) << i;
  return bits;
}

}  // namespace isotouch::field
