/// The work that a force does on a hand.
#pragma once

#include <array>
#include <cstddef>

namespace isotouch::touch {

/// Adds up force times way of the hand. A passive object never gives more than it got, so the sum stays at or below 0 but for what delay and sampling add.
class HandWork {
 public:
  /// One tick.
  ///
  /// hip       mm
  /// force     N, while the hand came there
  /// counts    false: this force did not reach the hand
  void add(const std::array<double, 3>& hip, const std::array<double, 3>& force, bool counts = true) {
    for (std::size_t axis = 0; known_ && counts && axis < 3; ++axis) mj_ += force[axis] * (hip[axis] - before_[axis]);
    before_ = hip;
    known_ = true;
  }
  /// The hand goes away. Its way to where it comes back is no way against a force.
  void lift() { known_ = false; }

  /// Since the first tick, mJ = N·mm.
  double mj() const { return mj_; }

 private:
  double mj_ = 0;
  bool known_ = false;
  std::array<double, 3> before_{};
};

}  // namespace isotouch::touch
