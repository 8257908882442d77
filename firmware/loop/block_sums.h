/// A hash for each block of a field's image, so that any part of it can be looked at again while it is used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/hash64.h"

namespace isotouch::loop {

class BlockSums {
 public:
  static constexpr std::size_t kBytes = 256;  ///< of a block; the last one of an image may be shorter

  /// bytes     of the largest image; a 64th of it is allocated and touched here and never again
  explicit BlockSums(std::size_t bytes) : sums_(blocks_of(bytes)) {}

  static std::size_t blocks_of(std::size_t bytes) { return (bytes + kBytes - 1) / kBytes; }

  /// Takes the image as it is now for right.
  void take(std::span<const std::uint8_t> image) {
    for (std::size_t block = 0; block < blocks_of(image.size()); ++block) sums_[block] = sum_of(image, block);
  }

  /// Is this block as it was taken?
  ///
  /// block     below the image's number of blocks
  /// tick      yes
  bool holds(std::span<const std::uint8_t> image, std::size_t block) const { return sum_of(image, block) == sums_[block]; }

 private:
  static std::uint32_t sum_of(std::span<const std::uint8_t> image, std::size_t block) {
    const std::size_t begin = block * kBytes;
    return static_cast<std::uint32_t>(hash64(image.data() + begin, std::min(kBytes, image.size() - begin)));
  }

  std::vector<std::uint32_t> sums_;
};

}  // namespace isotouch::loop
