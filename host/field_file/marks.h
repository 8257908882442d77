/// Which bricks of a field hold invented surface: one bit each (shared/SPEC.md, section 4.4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/field_view.h"

namespace isotouch::field_file {

class Marks {
 public:
  Marks() = default;
  /// bytes     as a checked packed field holds them; none = no brick is marked
  explicit Marks(std::span<const std::uint8_t> bytes) : bytes_(bytes.begin(), bytes.end()) {}

  bool any() const { return !bytes_.empty(); }
  bool has(std::uint32_t brick) const { return brick / 8 < bytes_.size() && (bytes_[brick / 8] >> brick % 8 & 1) != 0; }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  /// Marks the brick that holds sample (i, j, k); nothing is marked where the image stores none.
  void mark(const FieldView& view, std::int32_t i, std::int32_t j, std::int32_t k);

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Does the surface pass through this brick or less than a voxel beside it?
bool is_crossed(const FieldView& view, std::uint32_t brick);

/// The share of the surface that lies in marked bricks.
double share_of(const Marks& marks, const FieldView& view);

}  // namespace isotouch::field_file
