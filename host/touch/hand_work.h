/// The work that a force does on a hand.
///
/// real time   yes: constant cost, no allocation, but in doubles, so it is no part of the core
/// fails       never
#pragma once

#include <array>
#include <cstddef>

namespace isotouch::touch {

/// Adds up the force times the hand's displacement. A tick's force acts while the hand moves on to the place of the next tick. A passive object never returns
/// more energy than it received. So the sum exceeds 0 only by what delay and sampling add.
class HandWork {
 public:
  /// Adds one tick.
  ///
  /// hip       the hand's position, mm
  /// force     that this tick answers, N, in the same frame as hip
  /// counts    false: this force does not reach the hand, so it does no work
  void add(const std::array<double, 3>& hip, const std::array<double, 3>& force, bool counts = true) {
    for (std::size_t axis = 0; known_ && axis < 3; ++axis) mj_ += force_[axis] * (hip[axis] - before_[axis]);
    before_ = hip;
    force_ = counts ? force : std::array<double, 3>{};
    known_ = true;
  }
  /// The hand leaves, or is not seen for a while. Its way to the place where it comes back does not count as work.
  void lift() { known_ = false; }

  /// The work since the first tick, mJ = N·mm; positive: the object gave energy to the hand.
  double mj() const { return mj_; }

 private:
  double mj_ = 0;
  bool known_ = false;
  std::array<double, 3> before_{}, force_{};
};

}  // namespace isotouch::touch
