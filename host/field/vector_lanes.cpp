#include "host/field/vector_lanes.h"

namespace isotouch::field {

std::size_t vector_lanes() {
#ifdef __x86_64__
  // The first machines with AVX-512 slowed down for it, and did not know VBMI2.
  if (__builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vbmi2") != 0) return 16;
  if (__builtin_cpu_supports("avx2") != 0) return 8;
#endif
  return 4;
}

}  // namespace isotouch::field
