#include "host/evaluate/felt_comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "firmware/core/render.h"
#include "host/angle.h"
#include "host/cloud/mesh.h"
#include "host/error.h"
#include "host/evaluate/equal_answers.h"
#include "host/evaluate/god_object.h"
#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/parallel.h"
#include "host/to_double.h"
#include "shared/device_model.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;
using field::TriangleTree;

namespace {

constexpr double kFarthestAnswer = 2;  // times as far from the hand as the god-object: beyond, it is no other answer

/// What one hand says.
struct Felt {
  std::vector<double> direction_deg, force_n, depth;  ///< of the compared ticks
  std::size_t touching = 0, contact_differs = 0, jumps = 0, wrong_side = 0, force_without_contact = 0, equal = 0;
  FeltPlace worst_direction, worst_force;
};

/// No force at all is as wrong as one in the opposite direction.
double direction_error(const Vector3d& felt, const Vector3d& exact) {
  return felt.isZero(0) || exact.isZero(0) ? 180 : angle_deg(felt, exact);
}

/// One stiffness everywhere: the exact god-object has no other, and the shape is what is compared.
FieldView evenly_stiff(FieldView field) {
  field.stiffness_parts = nullptr;
  return field;
}

/// One hand on the field, in the core's integers.
class OnField {
 public:
  explicit OnField(const FieldView& field)
      : field_(field), model_(core::make_position_model(libnifalcon_model(), pure(), 1'000'000, field)) {}

  Output operator()(const Vec3<Mm>& hip) { return core::render_position(position_input(hip), field_, model_, state_); }

 private:
  static TickSettings pure() {
    TickSettings settings;
    settings.force_limit = Newton::of(32767);  // more than the core gives
    settings.ramp_ticks = 0;
    return settings;
  }

  const FieldView& field_;
  core::PositionModel model_;
  core::PositionState state_;
};

/// One hand on a mesh, with a god-object of its own.
class OnMesh {
 public:
  OnMesh(const TrueTrees& trees, double n_per_mm) : trees_(trees), n_per_mm_(n_per_mm) {}

  Output operator()(const Vec3<Mm>& hip) {
    Output out;
    out.hip = out.proxy = hip;
    const Vector3d hand = to_double(hip);
    if (!object_) {
      if (!field::is_inside(trees_.closed, hand)) object_.emplace(trees_.outer, hand);
      return out;
    }
    object_->settle(hand);
    if (!object_->touching()) return out;
    out.proxy = to_fixed<Mm>(object_->position());
    out.force = to_fixed<Newton>(n_per_mm_ * (object_->position() - hand));
    out.status = kContact;
    return out;
  }

 private:
  TrueTrees trees_;
  double n_per_mm_;
  std::optional<GodObject> object_;
};

class Comparer {
 public:
  Comparer(const FieldView& field, const TrueTrees& trees)
      : field_(evenly_stiff(field)), trees_(trees), tree_(trees.outer), tolerance_(kWrongSideVoxels * to_double(field.edge)) {}

  double tolerance() const { return tolerance_; }

  Felt run_on_field(const FeltHand& hand) const { return run(hand, OnField(field_)); }
  Felt run_on_mesh(const FeltHand& hand, const TrueTrees& other) const { return run(hand, OnMesh(other, to_double(field_.stiffness))); }

 private:
  template <class Rendering>
  Felt run(const FeltHand& hand, Rendering render) const {
    Felt felt;
    Output before;
    bool apart = false;
    for (std::size_t i = 0; i < hand.ticks.size(); ++i) {
      const Output out = render(hand.ticks[i].hip);
      judge(hand, i, before, out, apart, felt);
      before = out;
    }
    return felt;
  }

  Vector3d normal_at(const Vector3d& place) const { return cloud::face_normal(tree_.mesh(), tree_.nearest(place).face); }

  bool is_on_wrong_side(const Vector3d& proxy, const Vector3d& god) const {
    const Vector3d way = proxy - god;
    const double length = way.norm();
    if (length <= tolerance_) return false;
    if (field::is_inside(trees_.closed, proxy)) return tree_.nearest(proxy).distance > tolerance_;
    const auto hit = field::first_hit(tree_, god, way / length);
    return hit && hit->t < length && angle_deg(normal_at(proxy), normal_at(god)) > kOtherSideDeg;
  }

  /// Does the force lead to another place at which a god-object could rest?
  ///
  /// apart     the two have taken different ones before: the other one need not be equally near any more
  bool is_other_answer(const FeltTick& tick, const Output& out, const Vector3d& force, bool apart) const {
    if (force.isZero(0)) return false;  // it leads nowhere
    const Vector3d hip = to_double(tick.hip), way = tick.god - hip;
    const double depth = way.norm(), tolerance = equal_tolerance(depth);
    if (direction_error(force, way) <= kOtherDirectionDeg || (to_double(out.proxy) - hip).norm() >= kFarthestAnswer * depth) return false;
    const auto others = apart ? other_answers(tree_, hip, tick.god, 0, kFarthestAnswer * depth)
                              : other_answers(tree_, hip, tick.god, depth - tolerance, depth + tolerance);
    return std::any_of(others.begin(), others.end(), [&](const Vector3d& other) { return angle_deg(other, force) <= kOtherDirectionDeg; });
  }

  bool jumps(const FeltHand& hand, std::size_t i, const Output& before, const Output& out) const {
    if (i == 0 || (before.status & out.status & kContact) == 0) return false;
    const FeltTick &last = hand.ticks[i - 1], &now = hand.ticks[i];
    const double most = kJumpFactor * (to_double(now.hip) - to_double(last.hip)).norm() + kJumpMm;
    const bool exact_jumps = (now.god - last.god).norm() > most;
    return !exact_jumps && (to_double(out.proxy) - to_double(before.proxy)).norm() > most;
  }

  void judge(const FeltHand& hand, std::size_t i, const Output& before, const Output& out, bool& apart, Felt& felt) const {
    const FeltTick& tick = hand.ticks[i];
    const Vector3d hip = to_double(tick.hip), proxy = to_double(out.proxy), force = to_double(out.force);
    const bool touching = (out.status & kContact) != 0;
    const double depth = tick.touching ? (tick.god - hip).norm() : 0;
    const bool differs = touching != tick.touching;
    const bool jump = jumps(hand, i, before, out);
    const bool wrong = is_on_wrong_side(proxy, tick.god);
    const bool without_contact = !tick.touching && force.norm() > kForceWithoutContact;
    const bool compared = touching && tick.touching && depth >= kFeltDepths.front() && depth <= kFeltDepths.back();
    felt.touching += tick.touching ? 1U : 0U;
    // Where two places are equally near each may take its own; then they are apart until they agree again, or until the field's is no answer any more.
    apart = touching && tick.touching && !wrong && is_other_answer(tick, out, force, apart);
    if (!differs && !jump && !wrong && !without_contact && !compared) return;
    if (apart) {
      ++felt.equal;
      return;
    }
    felt.contact_differs += differs ? 1U : 0U;
    felt.jumps += jump ? 1U : 0U;
    felt.wrong_side += wrong ? 1U : 0U;
    felt.force_without_contact += without_contact ? 1U : 0U;
    if (!compared) return;
    FeltPlace place{hand.kind, hand.number, hand.from, i, hip, tick.god, proxy, force, to_double(field_.stiffness) * (tick.god - hip), 0,
                    0};
    place.direction_deg = direction_error(place.felt, place.exact);
    place.force_n = (place.felt - place.exact).norm();
    felt.direction_deg.push_back(place.direction_deg);
    felt.force_n.push_back(place.force_n);
    felt.depth.push_back(depth);
    if (place.direction_deg > felt.worst_direction.direction_deg) felt.worst_direction = place;
    if (place.force_n > felt.worst_force.force_n) felt.worst_force = place;
  }

  FieldView field_;
  TrueTrees trees_;
  const TriangleTree& tree_;  ///< of what can be touched
  double tolerance_;
};

FeltFigures figures_of(const std::vector<const FeltHand*>& hands, const std::vector<const Felt*>& felt) {
  FeltFigures figures;
  std::vector<double> direction, force;
  std::array<std::vector<double>, kFeltDepths.size() - 1> directions, forces;
  for (std::size_t h = 0; h < hands.size(); ++h) {
    const Felt& one = *felt[h];
    ++figures.hands;
    figures.ticks += hands[h]->ticks.size();
    figures.touching += one.touching;
    figures.contact_differs += one.contact_differs;
    figures.jumps += one.jumps;
    figures.wrong_side += one.wrong_side;
    figures.force_without_contact += one.force_without_contact;
    figures.equal_answers += one.equal;
    for (std::size_t i = 0; i < one.depth.size(); ++i) {
      direction.push_back(one.direction_deg[i]);
      force.push_back(one.force_n[i]);
      std::size_t range = 0;
      while (range + 2 < kFeltDepths.size() && one.depth[i] > kFeltDepths[range + 1]) ++range;
      directions[range].push_back(one.direction_deg[i]);
      forces[range].push_back(one.force_n[i]);
    }
  }
  figures.errors = {quantiles(std::move(direction)), quantiles(std::move(force))};
  for (std::size_t r = 0; r < directions.size(); ++r)
    figures.by_depth[r] = {quantiles(std::move(directions[r])), quantiles(std::move(forces[r]))};
  return figures;
}

/// What every hand feels, by `run`.
///
/// what      the surface beside the mesh, and a question to whoever named it
template <class Run>
FeltComparison compared(const std::vector<FeltHand>& hands, double tolerance, const std::array<const char*, 2>& what, const Run& run) {
  std::vector<Felt> felt(hands.size());
  field::in_parallel(hands.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) felt[i] = run(hands[i]);
  });
  FeltComparison comparison;
  comparison.wrong_side_mm = tolerance;
  std::vector<const FeltHand*> every_hand;
  std::vector<const Felt*> every_felt;
  for (std::size_t first = 0; first < hands.size();) {
    std::vector<const FeltHand*> of_kind;
    std::vector<const Felt*> felt_of_kind;
    std::size_t i = first;
    for (; i < hands.size() && hands[i].kind == hands[first].kind; ++i) {
      of_kind.push_back(&hands[i]);
      felt_of_kind.push_back(&felt[i]);
      if (felt[i].worst_direction.direction_deg > comparison.worst_direction.direction_deg)
        comparison.worst_direction = felt[i].worst_direction;
      if (felt[i].worst_force.force_n > comparison.worst_force.force_n) comparison.worst_force = felt[i].worst_force;
    }
    comparison.kinds.push_back({hands[first].kind, figures_of(of_kind, felt_of_kind)});
    every_hand.insert(every_hand.end(), of_kind.begin(), of_kind.end());
    every_felt.insert(every_felt.end(), felt_of_kind.begin(), felt_of_kind.end());
    first = i;
  }
  comparison.all = figures_of(every_hand, every_felt);
  if (comparison.all.errors.direction_deg.count == 0) {
    throw InputError(std::string("no hand feels both ") + what[0] + " and the mesh between 0.1 and 1 mm deep: nothing was compared; " +
                     what[1]);
  }
  return comparison;
}

}  // namespace

FeltComparison compare_felt(const FieldView& field, const TrueTrees& trees, const std::vector<FeltHand>& hands) {
  const Comparer comparer(field, trees);
  return compared(hands, comparer.tolerance(), {"the field", "is this the mesh of the field?"},
                  [&](const FeltHand& hand) { return comparer.run_on_field(hand); });
}

FeltComparison compare_felt(const FieldView& field, const TrueTrees& other, const TrueTrees& trees, const std::vector<FeltHand>& hands) {
  const Comparer comparer(field, trees);
  return compared(hands, comparer.tolerance(), {"the other mesh", "is it a mesh of the same object?"},
                  [&](const FeltHand& hand) { return comparer.run_on_mesh(hand, other); });
}

}  // namespace isotouch::evaluate
