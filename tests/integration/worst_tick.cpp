/// Searches for the tick with the most instructions: an evolution over hands, devices and settings whose fitness is what hil/instructions/count counts.
///
///     worst_tick "hil/instructions/count REPLAY" FIELD OUT [SEED [GENERATIONS]]
///
/// A generation is one recording of a device that is restarted for each of its hands, so that every one begins from nothing. The best go on; others are
/// crossed and changed, and so are device and settings. The same seed and the same programs give the same search. OUT becomes the recording of the worst.
/// Prints {"seed", "generations", "ticks", "hip_to_force", "counts_to_words"}: the most instructions of any tick that was tried.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/field_file/open_field.h"
#include "host/motion/device_in_hand.h"
#include "host/to_double.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "tests/support/random.h"

namespace {

using namespace isotouch;
using test::Point;
using test::Random;

constexpr int kSettle = 16;  // ticks at the first knot: the device is homed, its pose found, forces begin
constexpr int kKnots = 6, kTicksBetween = 8;
constexpr int kTicks = kSettle + (kKnots - 1) * kTicksBetween;
constexpr std::size_t kHands = 48, kParents = 12;

/// What one hand does, and what happens to it.
struct Hand {
  std::array<Point, kKnots> knots;  // mm, workspace
  int lost_at = 0, lost = 0;        // ticks without a packet
  int late_at = 0;
  int set_at = 0;
  SettingChange change;
};

struct Setup {
  TickSettings settings;
  DeviceModel device = libnifalcon_model();
};

template <class Q>
Q between(Random& random, Q low, Q high) {
  return Q::from_raw(low.raw() + static_cast<std::int32_t>(random.uniform(0, 1) * (static_cast<double>(high.raw()) - low.raw())));
}

int below(Random& random, int limit) { return static_cast<int>(random.bits() % static_cast<std::uint64_t>(limit)); }
bool chance(Random& random, double share) { return random.uniform(0, 1) < share; }

/// Everything on; limits anywhere from always felt to never.
Setup any_setup(Random& random) {
  Setup setup;
  TickSettings& s = setup.settings;
  s.stiffness = chance(random, 0.5) ? Stiffness{} : between(random, Stiffness::of(0.05), Stiffness::of(20));
  s.damping = between(random, Damping{}, Damping::of(0.002));
  s.force_limit = between(random, Newton::of(0.01), Newton::of(20));
  s.ramp_ticks = chance(random, 0.5) ? 1000 : 5;
  s.friction = between(random, Ratio::of(0.01), Ratio::of(rows::kFriction.high));
  s.friction_damping = between(random, Damping{}, Damping::of(0.01));
  s.hand_damping = between(random, Damping{}, Damping::of(0.01));
  s.passivity = between(random, Damping::of(0.0001), Damping::of(rows::kPassivity.high));
  s.device_damping = between(random, Damping{}, Damping::of(0.005));
  s.weight = between(random, Newton::of(rows::kWeight.low), Newton::of(rows::kWeight.high));
  s.delay_ticks = static_cast<std::uint32_t>(below(random, 8));
  DeviceModel& d = setup.device;
  d.word_limit = chance(random, 0.5) ? 4095 : 100;
  d.word_slew = chance(random, 0.5) ? 1'000'000 : 20'000;
  d.penetration_limit = Mm::of(200);
  d.speed_limit = MmPerS::of(100'000);
  d.count_jump = 4000;
  d.ramp_ticks = chance(random, 0.5) ? 1 : 1000;
  d.heat_word = 1 + below(random, 4095);
  return setup;
}

Hand any_hand(Random& random, const FieldView& field) {
  Hand hand;
  for (Point& knot : hand.knots) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double origin = to_double(axis == 0 ? field.origin.x : axis == 1 ? field.origin.y : field.origin.z);
      knot[axis] = origin + random.uniform(0, 1) * to_double(field.edge) * field.size[axis];
    }
  }
  hand.lost_at = below(random, kTicks), hand.lost = below(random, 4);
  hand.late_at = below(random, kTicks);
  hand.set_at = below(random, kTicks);
  const auto setting = static_cast<TickSetting>(below(random, 9));
  hand.change = {setting, setting == TickSetting::kNone ? 0 : 1 + below(random, 200'000)};
  return hand;
}

/// The children of two, changed here and there: a knot to any place, or by a little.
Hand child_of(const Hand& a, const Hand& b, Random& random, const FieldView& field) {
  const Hand fresh = any_hand(random, field);
  Hand hand = a;
  for (std::size_t i = 0; i < hand.knots.size(); ++i) {
    if (chance(random, 0.3)) hand.knots[i] = b.knots[i];
    if (chance(random, 0.1)) hand.knots[i] = fresh.knots[i];
    if (chance(random, 0.5)) hand.knots[i] = hand.knots[i] + random.in_ball(chance(random, 0.5) ? 0.2 : 3);
  }
  if (chance(random, 0.2)) hand.lost_at = fresh.lost_at, hand.lost = fresh.lost;
  if (chance(random, 0.2)) hand.late_at = fresh.late_at;
  if (chance(random, 0.2)) hand.set_at = fresh.set_at, hand.change = fresh.change;
  return hand;
}

/// What the device sends in each tick.
std::vector<Input> inputs_of(const Hand& hand, const DeviceModel& device) {
  motion::DeviceInHand in_hand(device);
  std::vector<Input> inputs;
  std::uint16_t age = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const int after = std::max(tick - kSettle, 0);
    const auto knot = static_cast<std::size_t>(after / kTicksBetween);
    const double part = static_cast<double>(after % kTicksBetween) / kTicksBetween;
    const Point place = hand.knots[knot] + (hand.knots[knot + 1] - hand.knots[knot]) * part;
    Input in = position_input(to_fixed<Mm>(Eigen::Vector3d(place.x, place.y, place.z)));
    in.fresh = tick < kSettle || tick < hand.lost_at || tick >= hand.lost_at + hand.lost;
    in.age = age = static_cast<std::uint16_t>(in.fresh ? 0 : age + 1);
    Input input = in_hand(in);
    if (tick == 0) input.requests = kRequestRestart;
    if (tick == hand.late_at) input.late = 1;
    if (tick == hand.set_at && is_valid(hand.change)) input.change = hand.change;
    inputs.push_back(input);
  }
  return inputs;
}

struct Worst {
  std::uint64_t hip_to_force = 0, counts_to_words = 0;
  std::uint64_t sum() const { return hip_to_force + counts_to_words; }
};

/// The most of each of the ticks of one hand; rows are what hil/instructions/count writes.
Worst worst_of(std::istream& rows) {
  Worst worst;
  for (int tick = 0; tick < kTicks; ++tick) {
    std::uint64_t packet = 0, pose = 0, sampler = 0, proxy = 0, feel = 0, words = 0;
    if (!(rows >> packet >> pose >> sampler >> proxy >> feel >> words)) throw std::runtime_error("fewer ticks were counted than were sent");
    const std::uint64_t hip = sampler + proxy + feel;
    worst.hip_to_force = std::max(worst.hip_to_force, hip);
    worst.counts_to_words = std::max(worst.counts_to_words, packet + pose + hip + words);
  }
  return worst;
}

void record(const FieldView& field, const Setup& setup, const std::vector<Hand>& hands, const std::string& file) {
  TraceHeader header;
  header.device = setup.device;
  header.settings = setup.settings;
  trace::Run run(field, header);
  trace::TraceWriter writer(file, run.header());
  for (const Hand& hand : hands) {
    for (const Input& input : inputs_of(hand, setup.device)) writer.append(run.step(input));
  }
  writer.finish();
}

struct Tried {
  Hand hand;
  Worst worst;
};

int search(const std::string& count, const std::string& field, const std::string& out, std::uint64_t seed, int generations) {
  const field_file::OpenField open = field_file::open_field(field);
  Random random(seed);
  Setup best_setup = any_setup(random);
  std::vector<Tried> parents;
  Worst most;
  std::uint64_t ticks = 0, best = 0;
  for (int generation = 0; generation < generations; ++generation) {
    const Setup setup = chance(random, 0.4) ? any_setup(random) : best_setup;
    std::vector<Hand> hands;
    for (const Tried& parent : parents) hands.push_back(parent.hand);
    while (hands.size() < kHands) {
      if (parents.empty() || chance(random, 0.2)) {
        hands.push_back(any_hand(random, open.view));
      } else {
        const auto any = [&]() -> const Hand& { return parents[random.bits() % parents.size()].hand; };
        hands.push_back(child_of(any(), any(), random, open.view));
      }
    }
    const std::string part = out + ".part", rows = out + ".rows";
    record(open.view, setup, hands, part);
    if (std::system((count + " " + field + " " + part + " " + rows + " >/dev/null").c_str()) != 0)
      throw std::runtime_error("the counter failed");
    std::ifstream counted(rows);
    std::vector<Tried> tried;
    for (const Hand& hand : hands) tried.push_back({hand, worst_of(counted)});
    std::stable_sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) { return a.worst.sum() > b.worst.sum(); });
    ticks += hands.size() * kTicks;
    for (const Tried& t : tried) {
      most.hip_to_force = std::max(most.hip_to_force, t.worst.hip_to_force);
      most.counts_to_words = std::max(most.counts_to_words, t.worst.counts_to_words);
    }
    if (tried.front().worst.sum() > best) {
      best = tried.front().worst.sum();
      best_setup = setup;
      record(open.view, setup, {tried.front().hand}, out);
    }
    tried.resize(kParents);
    parents = std::move(tried);
  }
  std::remove((out + ".part").c_str());
  std::remove((out + ".rows").c_str());
  std::printf("{\"seed\": %llu, \"generations\": %d, \"ticks\": %llu, \"hip_to_force\": %llu, \"counts_to_words\": %llu}\n",
              static_cast<unsigned long long>(seed), generations, static_cast<unsigned long long>(ticks),
              static_cast<unsigned long long>(most.hip_to_force), static_cast<unsigned long long>(most.counts_to_words));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4 || argc > 6) {
    std::fprintf(stderr, "usage: worst_tick \"hil/instructions/count REPLAY\" FIELD OUT [SEED [GENERATIONS]]\n");
    return 2;
  }
  return search(argv[1], argv[2], argv[3], argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1, argc > 5 ? std::atoi(argv[5]) : 40);
} catch (const std::exception& e) {
  std::fprintf(stderr, "worst_tick: %s\n", e.what());
  return 1;
}
