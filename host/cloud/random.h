/// The project's one source of random numbers: the same sequence for a seed on every machine.
///
/// source    SplitMix64: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014
#pragma once

#include <cstdint>

namespace isotouch::cloud {

class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  constexpr std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /// In [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// In [low, high).
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Nearly normal, mean 0, standard deviation 1, within ±6: twelve uniform numbers need no logarithm, which differs between libraries.
  constexpr double gaussian() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace isotouch::cloud
