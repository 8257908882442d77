/// Four numbers of 32 bits at once, where every processor of the kind has registers for them: x86-64 and 64-bit ARM. Elsewhere ISOTOUCH_FOUR is not defined,
/// and numbers are computed one by one, to the same bits.
///
/// tick      yes
#pragma once

#include <bit>
#include <cstdint>

#if defined(__SSE2__)
#define ISOTOUCH_FOUR
#elif defined(__aarch64__)
#define ISOTOUCH_FOUR
#include <arm_neon.h>
#endif

namespace isotouch::core {

/// The upper word of a product whose second factor is 16 bits above 16 bits of zeros.
inline std::int32_t upper_words(std::int32_t a, std::int32_t t) { return static_cast<std::int32_t>((std::int64_t{a} * t) >> 32); }

#ifdef ISOTOUCH_FOUR

using Four = std::int32_t __attribute__((vector_size(16)));
using EightShorts = std::int16_t __attribute__((vector_size(16)));

inline Four four(std::int32_t all) { return Four{all, all, all, all}; }

/// The same in each lane, for |a| below 2^30.
inline Four upper_words(Four a, Four t) {
#if defined(__SSE2__)
  // With a = 2^16 h + l, l from -2^15 to below 2^15, and t = 2^16 s: h s + (l s >> 16). Both products are those of upper halves, and a half beside them is 0.
  const Four high = __builtin_ia32_pmaddwd128(std::bit_cast<EightShorts>(a + 0x8000), std::bit_cast<EightShorts>(t));
  const Four low = std::bit_cast<Four>(__builtin_ia32_pmulhw128(std::bit_cast<EightShorts>(a << 16), std::bit_cast<EightShorts>(t))) >> 16;
  return high + low;
#else
  return std::bit_cast<Four>(vqdmulhq_s32(std::bit_cast<int32x4_t>(a), std::bit_cast<int32x4_t>(t >> 1)));  // it doubles
#endif
}

#endif

}  // namespace isotouch::core
