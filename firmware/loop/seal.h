/// A hash over a value that must not change until it is asked again: a difference is a flipped bit or a stray write.
#pragma once

#include <cstdint>
#include <type_traits>

#include "shared/hash64.h"

namespace isotouch::loop {

/// tick      yes: constant cost for a type, about 0.2 ns a byte on x86-64
class Seal {
 public:
  /// Holds from now on, for this object where it stands: padding counts.
  template <class T>
  void close(const T& value) {
    hash_ = hash_of(value);
  }

  /// Is the object as it was closed?
  template <class T>
  bool holds(const T& value) const {
    return hash_ == hash_of(value);
  }

 private:
  template <class T>
  static std::uint64_t hash_of(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return hash64(reinterpret_cast<const std::uint8_t*>(&value), sizeof value);
  }

  std::uint64_t hash_ = 0;
};

}  // namespace isotouch::loop
