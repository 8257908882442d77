#include "host/motion/motion.h"

#include <cmath>
#include <utility>

#include "host/error.h"
#include "host/motion/felt_surface.h"
#include "host/motion/gestures.h"

namespace isotouch::motion {

using Eigen::Vector3d;

namespace {

using Gesture = void (Gestures::*)();

struct Kind {
  const char* name;
  Gesture gesture;
  int round;     // gestures in one round
  double pace;   // mm/s at most, where there is no object
  double reach;  // mm from the centre, where there is no object
};

constexpr Kind kKinds[] = {
    {"press", &Gestures::press, 8, 50, 50},   {"slide", &Gestures::slide, 6, 300, 50}, {"tap", &Gestures::tap, 6, 400, 50},
    {"corner", &Gestures::corner, 8, 50, 50}, {"graze", &Gestures::graze, 4, 30, 50},  {"stab", &Gestures::stab, 12, 1000, 50},
    {"leave", &Gestures::leave, 3, 600, 100},
};
constexpr double kRoamSeconds = 4;  // one round without an object
constexpr double kReach = 50;       // mm, the Falcon's
constexpr double kSteepest = 8.3;   // path per turn and reach, at most: 6 for one wave, 8.26 seen for three over 2,000,000 ticks
constexpr int kTourRound = 2;       // gestures of each kind in one round of the tour

/// The cube [-1, 1]³ onto the unit ball, corners too, by square roots.
Vector3d cube_to_ball(const Vector3d& p) {
  const Vector3d s = p.cwiseProduct(p);
  return {p.x() * std::sqrt(1 - s.y() / 2 - s.z() / 2 + s.y() * s.z() / 3),
          p.y() * std::sqrt(1 - s.z() / 2 - s.x() / 2 + s.z() * s.x() / 3),
          p.z() * std::sqrt(1 - s.x() / 2 - s.y() / 2 + s.x() * s.y() / 3)};
}

/// Three waves whose periods have no small common multiple: a path that comes near every place of the ball.
///
/// turns     of the first wave, from before and carried on
void roam(Hand& hand, const Kind& kind, const Vector3d& phase, double& turns) {
  for (double time = 0; time < kRoamSeconds && !hand.done(); time += hand.period_s()) {
    const double ends = minimum_jerk(time) * minimum_jerk(kRoamSeconds - time);
    const double reach = kReach + ends * (kind.reach - kReach);
    turns += hand.period_s() * kind.pace / (kSteepest * kind.reach);
    const Vector3d waves(wave(turns + phase.x()), wave(turns * 0.7548776662466927 + phase.y()),
                         wave(turns * 0.5698402909980532 + phase.z()));
    hand.step(reach * cube_to_ball(waves));
  }
}

std::vector<Kind> chosen_kinds(const std::string& name) {
  std::vector<Kind> chosen;
  for (const Kind& kind : kKinds) {
    if (name == "tour" || name == kind.name) chosen.push_back(kind);
  }
  if (!chosen.empty()) return chosen;
  std::string known;
  for (const std::string& kind : motion_kinds()) known += (known.empty() ? "" : " ") + kind;
  throw InputError("no motion is called '" + name + "'; choose one of: " + known);
}

}  // namespace

const std::vector<std::string>& motion_kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Kind& kind : kKinds) list.emplace_back(kind.name);
    list.emplace_back("tour");
    return list;
  }();
  return names;
}

std::uint64_t make_motion(const FieldView* field, const MotionOptions& options, Hand::Emit emit) {
  const std::vector<Kind> kinds = chosen_kinds(options.kind);
  const double period_s = options.period_ns * 1e-9;
  Hand hand({options.ticks, period_s, loss_begins(options.lost_share), ~options.seed}, std::move(emit));
  cloud::Random random(options.seed);
  if (field == nullptr) {
    Vector3d phase;
    for (double& turns : phase) turns = random.uniform();
    double turns = 0;
    do {
      for (const Kind& kind : kinds) roam(hand, kind, phase, turns);
    } while (options.ticks != 0 && !hand.done());
    return hand.emitted();
  }
  const FeltSurface surface(*field);
  Gestures gestures(surface, hand, random);
  do {
    for (const Kind& kind : kinds) {
      const int count = kinds.size() > 1 ? kTourRound : kind.round;
      for (int i = 0; i < count && !hand.done(); ++i) (gestures.*kind.gesture)();
    }
  } while (options.ticks != 0 && !hand.done());
  return hand.emitted();
}

}  // namespace isotouch::motion
