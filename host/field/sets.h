/// Sets that grow together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isotouch::field {

/// At first each of 0 to count - 1 is a set of its own.
class Sets {
 public:
  explicit Sets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0U); }

  std::size_t size() const { return above_.size(); }
  /// The one member that stands for a member's set.
  std::uint32_t of(std::uint32_t member) {
    while (above_[member] != member) member = above_[member] = above_[above_[member]];
    return member;
  }
  /// root, other   each stands for its set; `root` stands for both from now on
  void join(std::uint32_t root, std::uint32_t other) { above_[other] = root; }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace isotouch::field
