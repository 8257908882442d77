/// What hands feel of a field beside what they would feel of its true surface, tick by tick.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "host/evaluate/felt_hands.h"
#include "host/evaluate/true_trees.h"
#include "host/quantiles.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Depths of the HIP below the god-object whose directions and forces are compared, mm, and the ranges in tables.
inline constexpr std::array<double, 4> kFeltDepths = {0.1, 0.2, 0.5, 1.0};
/// A proxy jumps if it moves by more than this multiple of the hand's step and kJumpMm.
inline constexpr double kJumpFactor = 3;
inline constexpr double kJumpMm = 0.02;
/// How far inside the true body a proxy may be, voxels.
inline constexpr double kWrongSideVoxels = 0.5;
/// N: a force that is felt though the god-object touches nothing.
inline constexpr double kForceWithoutContact = 0.1;

/// Errors in the ticks in which both touch.
struct FeltErrors {
  Quantiles direction_deg;  ///< between the forces
  Quantiles force_n;        ///< length of their difference
};

struct FeltFigures {
  std::size_t hands = 0;
  std::size_t ticks = 0;
  std::size_t touching = 0;                                 ///< ticks in which the god-object touches
  FeltErrors errors;                                        ///< HIP 0.1 to 1 mm deep
  std::array<FeltErrors, kFeltDepths.size() - 1> by_depth;  ///< in each range
  std::size_t contact_differs = 0;                          ///< ticks: one of the two touches, the other does not
  std::size_t jumps = 0;                                    ///< ticks: the proxy jumps and the god-object does not
  std::size_t wrong_side = 0;                               ///< ticks: the proxy is in the body or on the other side of a part
  std::size_t force_without_contact = 0;                    ///< ticks: more than kForceWithoutContact where the god-object touches nothing
  /// Ticks left out of all but `ticks` and `touching`: two places are equally near, and the force leads to the other one; or the two took different ones
  /// there, and since then it has led to a place where a god-object could rest, less than twice as far from the hand as the one where it does.
  std::size_t equal_answers = 0;
};

/// One tick, for people.
struct FeltPlace {
  FeltKind kind = FeltKind::kPress;
  std::size_t hand = 0;  ///< its number
  std::string from;      ///< the recording
  std::size_t tick = 0;
  Eigen::Vector3d hip = Eigen::Vector3d::Zero(), god = Eigen::Vector3d::Zero(), proxy = Eigen::Vector3d::Zero();  ///< mm, workspace
  Eigen::Vector3d felt = Eigen::Vector3d::Zero(), exact = Eigen::Vector3d::Zero();                                ///< N
  double direction_deg = 0;
  double force_n = 0;
};

struct FeltComparison {
  struct Kind {
    FeltKind kind;
    FeltFigures figures;
  };
  std::vector<Kind> kinds;  ///< those that the hands have
  FeltFigures all;
  FeltPlace worst_direction, worst_force;  ///< of the ticks in `errors`; the first of equals
  double wrong_side_mm = 0;                ///< the tolerance
};

/// Runs the hands through the core's integers on the field: a pure spring of the field's stiffness, without ramp, limit, friction and damping. The exact
/// force is that stiffness times god-object minus HIP.
///
/// field     of any method
/// trees     of the true surface: workspace, mm
/// hands     planned on it
/// returns   the same for any number of threads
/// fails     InputError when no tick was compared
FeltComparison compare_felt(const FieldView& field, const TrueTrees& trees, const std::vector<FeltHand>& hands);

/// The same with a god-object on another mesh in place of the field: what is felt of a surface that is nearly the true one. A hand that begins inside
/// it feels nothing until it has left.
///
/// field     gives the stiffness and the tolerance of the wrong side
/// other     of that mesh: workspace, mm
FeltComparison compare_felt(const FieldView& field, const TrueTrees& other, const TrueTrees& trees, const std::vector<FeltHand>& hands);

}  // namespace isotouch::evaluate
