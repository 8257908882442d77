/// Traces that stand beside each other by their numbers: of "a/r.trace" the first is "a/r-1.trace".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::recording {

class NumberedTraces {
 public:
  /// Looks which there are.
  ///
  /// name      of all of them, without a number
  explicit NumberedTraces(const std::string& name);

  /// The name with the number above every one that is in use: by a trace, by what a kill left of one, or by patches.
  /// If nobody may look which there are, it is at least free.
  std::string next() const;

  /// Removes the oldest traces.
  ///
  /// most      that stay
  void forget_oldest(std::size_t most) const;

 private:
  std::string numbered(std::size_t number) const { return begin_ + std::to_string(number) + extension_; }

  std::string begin_, extension_;
  std::vector<std::size_t> whole_;  ///< the oldest first
  std::size_t highest_ = 0;
};

}  // namespace isotouch::recording
