/// What libFuzzer hands over, as the doors want it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "shared/bytes.h"

namespace isotouch::fuzz {

/// Ends the program as a finding when a property does not hold.
inline void hold(bool property, const char* what) {
  if (property) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// A copy that may be changed and that stands on an 8-byte boundary, with nothing readable behind its end.
class Copy {
 public:
  Copy(const std::uint8_t* data, std::size_t size) : words_((size + 7) / 8), size_(size) {
    if (size > 0) std::memcpy(words_.data(), data, size);
  }
  std::span<std::uint8_t> bytes() { return {reinterpret_cast<std::uint8_t*>(words_.data()), size_}; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_;
};

/// Takes values from the front; zeros where nothing is left.
class Front {
 public:
  Front(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  bool empty() const { return left_ == 0; }
  template <class T>
  T take() {
    std::uint8_t bytes[sizeof(T)] = {};
    const std::size_t taken = std::min(left_, sizeof(T));
    if (taken > 0) std::memcpy(bytes, data_, taken);
    data_ += taken;
    left_ -= taken;
    return load_le<T>(bytes);
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace isotouch::fuzz
