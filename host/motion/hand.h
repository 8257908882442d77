/// A hand without a person: moves as people do and says each tick where it is.
///
/// Positions are doubles, made by + − × ÷ and square roots alone, so the rounded ones are the same on every machine.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "host/cloud/random.h"
#include "shared/tick_io.h"

namespace isotouch::motion {

/// 0 at 0, 1 at 1, velocity and acceleration zero at both, peak velocity 15/8. `share` is clamped to [0, 1].
///
/// source    minimum-jerk movement: Flash and Hogan, J. Neuroscience 5(7), 1985
double minimum_jerk(double share);

/// A smooth wave of period 1: 1 at 0, -1 at one half, slope zero at both, steepest slope 6.
double wave(double phase);

/// The `loss_begins` with which that share of all samples is lost. A loss takes two of them on average.
///
/// share     0 to 0.5
constexpr double loss_begins(double share) { return share / (2 - share); }

/// Gives a tick the field of a recorded one: its generation, and the patch that it takes over, if any.
void keep_field(const Input& recorded, Input& tick);

class Hand {
 public:
  using Emit = std::function<void(const Input&)>;

  struct Options {
    std::uint64_t ticks = 0;  ///< stops emitting after so many; 0 = never
    double period_s = 0.001;
    double loss_begins =
        0.0;  ///< probability that a sample does not arrive although the one before did; the last one is repeated 1 to 3 ticks long
    std::uint64_t seed = 1;  ///< of the losses
  };

  Hand(const Options& options, Emit emit);

  /// Moves there within this tick. The first call is where the hand begins.
  void step(const Eigen::Vector3d& to);
  /// Straight, minimum jerk, at least one tick; `peak` in mm/s.
  void move(const Eigen::Vector3d& to, double peak);
  /// Along the polyline `via` with one minimum-jerk profile over its whole length.
  void move_along(const std::vector<Eigen::Vector3d>& via, double peak);
  /// Stays for so many seconds.
  void hold(double seconds);

  const Eigen::Vector3d& position() const { return position_; }
  double period_s() const { return options_.period_s; }
  /// All ticks have been emitted; gestures end their loops.
  bool done() const { return options_.ticks != 0 && emitted_ >= options_.ticks; }
  std::uint64_t emitted() const { return emitted_; }

 private:
  Options options_;
  Emit emit_;
  cloud::Random losses_;
  int lost_ticks_ = 0;
  Input last_;
  std::uint64_t emitted_ = 0;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
};

}  // namespace isotouch::motion
