#include "host/motion/mutate_packets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>

#include "host/cloud/random.h"
#include "host/error.h"
#include "host/to_double.h"

namespace isotouch::motion {

namespace {

using Counts = std::array<std::int16_t, 3>;

std::int16_t wrapped(std::int32_t count) { return static_cast<std::int16_t>(static_cast<std::uint16_t>(count)); }

/// Changes a well-formed packet; any other stays as it is.
template <class Change>
void rewrite(FalconPacket& packet, Change change) {
  const Result<FalconReply> read = decode_reply(packet);
  if (!read) return;
  FalconReply reply = *read;
  change(reply);
  packet = encode(reply);
}

void add_counts(const std::array<std::int32_t, 3>& offset, FalconPacket& packet) {
  rewrite(packet, [&](FalconReply& reply) {
    for (std::size_t i = 0; i < 3; ++i) reply.counts[i] = wrapped(reply.counts[i] + offset[i]);
  });
}

void wrap(Recording& recording, cloud::Random& random) {
  constexpr std::int32_t kLow = std::numeric_limits<std::int16_t>::min(), kHigh = std::numeric_limits<std::int16_t>::max();
  Counts first{}, low, high;
  low.fill(kHigh), high.fill(kLow);
  for (const Input& in : recording.inputs) {
    const Result<FalconReply> reply = decode_reply(in.packet);
    if (!reply) continue;
    if (low[0] > high[0]) first = reply->counts;
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], reply->counts[i]);
      high[i] = std::max(high[i], reply->counts[i]);
    }
  }
  const std::uint64_t legs = 1 + random.bits() % 7;
  std::array<std::int32_t, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t middle = (low[i] + high[i]) / 2;
    if ((legs >> i & 1U) == 0 || low[i] > high[i]) continue;
    offset[i] = (first[i] <= middle ? kHigh : kLow) - middle;  // the first count stands before the end, where it means what it meant
    DeviceLeg& leg = recording.header.device.legs[i];
    const std::int64_t turned = round_shift(std::int64_t{leg.per_count.raw()} * offset[i], AnglePerCount::kFractionBits);
    leg.at_zero = leg.at_zero - Angle::from_raw(static_cast<std::uint32_t>(turned));
  }
  for (Input& in : recording.inputs) add_counts(offset, in.packet);
}

/// Such a tick keeps its field, and neither restarts nor changes a setting (SPEC.md, section 3.2).
bool takes_patch(const Input& in) { return (in.requests & kRequestMoved) != 0; }

/// What is wrong in a tick, each for so many ticks more.
struct Trouble {
  std::uint64_t missing = 0, malformed = 0, late = 0, emergency = 0, enable = 0, jumped = 0, unhomed = 0, no_field = 0, button = 0;
  std::uint64_t reborn = 0, stop_in = 0;
  std::array<std::int32_t, 3> jump{};
  std::size_t bad_byte = 0;
};
constexpr std::uint64_t kTroubles = 15;

void begin(std::uint64_t kind, cloud::Random& random, Trouble& t, Input& in) {
  switch (kind) {
    case 0: t.missing = 1 + random.bits() % 8; break;
    case 1: t.missing = 150; break;  // silent for longer than any hold
    case 2: t.malformed = 1 + random.bits() % 3, t.bad_byte = random.bits() % 16; break;
    case 3: t.late = 1 + random.bits() % 20; break;
    case 4: in.requests |= kRequestStop; break;
    case 5: t.emergency = 30; break;
    case 6: t.enable = 1 + random.bits() % 5; break;
    case 7: t.jumped = 50, t.jump = {}, t.jump[random.bits() % 3] = 450 + static_cast<std::int32_t>(random.bits() % 1000); break;
    case 8: t.unhomed = 1 + random.bits() % 40; break;
    case 9: t.no_field = 30; break;
    case 10: in.requests |= kRequestRestart, t.missing = random.bits() % 4; break;
    case 11: t.missing = 5, t.reborn = 20; break;    // the device was without power
    case 12: t.button = 120, t.stop_in = 40; break;  // a button that is stuck while somebody stops
    case 13: t.late = 150; break;                    // for longer than any hold
    default: t.button = 40; break;
  }
}

/// One tick of what has begun.
void apply(Trouble& t, cloud::Random& random, const Input& before, Input& in) {
  const auto goes_on = [](std::uint64_t& ticks) { return ticks > 0 && ticks-- > 0; };
  if (goes_on(t.jumped)) add_counts(t.jump, in.packet);
  if (goes_on(t.unhomed)) rewrite(in.packet, [&](FalconReply& reply) { reply.homed = static_cast<std::uint8_t>(random.bits() % 7); });
  if (goes_on(t.button)) rewrite(in.packet, [](FalconReply& reply) { reply.buttons = 0x0F; });
  if (t.missing == 0 && goes_on(t.reborn)) rewrite(in.packet, [](FalconReply& reply) { reply = {}; });
  if (goes_on(t.stop_in) && t.stop_in == 0) in.requests |= kRequestStop;
  if (goes_on(t.malformed)) in.packet[t.bad_byte] = 0x00;  // no byte of a packet may be that
  if (goes_on(t.missing)) {
    in.packet = before.packet;
    in.fresh = false;
    in.age = static_cast<std::uint16_t>(before.age + 1);
  }
  if (goes_on(t.late)) in.late = static_cast<std::uint8_t>(1 + random.bits() % kMaxLate);
  if (goes_on(t.emergency)) in.lines |= kLineStop;
  if (goes_on(t.enable)) in.lines |= kLineEnableWrong;
  if (goes_on(t.no_field) && !takes_patch(in)) in.field_generation = 0;
}

void faults(Recording& recording, cloud::Random& random) {
  std::array<std::uint64_t, kTroubles> round{};
  std::size_t begun = 0;
  Trouble trouble;
  std::size_t next = 150 + random.bits() % 350, resume = 0;
  for (std::size_t tick = 1; tick < recording.inputs.size(); ++tick) {
    Input& in = recording.inputs[tick];
    if (tick == next && takes_patch(in)) ++next;
    if (tick == next) {
      if (begun % kTroubles == 0) {  // each once, in a new order
        for (std::size_t i = 0; i < round.size(); ++i) round[i] = i;
        for (std::size_t i = round.size() - 1; i > 0; --i) std::swap(round[i], round[random.bits() % (i + 1)]);
      }
      begin(round[begun++ % kTroubles], random, trouble, in);
      resume = tick + 160 + random.bits() % 60;
      next = resume + 60 + random.bits() % 300;
    }
    if (tick == resume) in.requests |= kRequestResume;
    apply(trouble, random, recording.inputs[tick - 1], in);
  }
}

void settings(Recording& recording, cloud::Random& random) {
  struct Range {
    double low, high;
  };
  constexpr std::array<Range, kLiveSettings> kRanges = {
      {{0.1, 3}, {0, 0.002}, {0.5, 9}, {0, 1}, {0, 0.002}, {0, 0.01}, {0, 0.02}, {-1, 1}}};
  for (std::size_t tick = 40; tick < recording.inputs.size(); tick += 40 + random.bits() % 160) {
    const std::size_t chosen = random.bits() % kLiveSettings;
    const double value = random.uniform(kRanges[chosen].low, kRanges[chosen].high);
    if (takes_patch(recording.inputs[tick])) continue;
    recording.inputs[tick].change = {
        static_cast<TickSetting>(chosen + 1),
        static_cast<std::int32_t>(value * static_cast<double>(std::int64_t{1} << kTickSettingRows[chosen]->fraction_bits))};
  }
}

void resume(Recording& recording, cloud::Random& random) {
  for (std::size_t tick = 200 + random.bits() % 100; tick < recording.inputs.size(); tick += 200 + random.bits() % 100) {
    recording.inputs[tick].requests |= kRequestResume;
  }
}

void grip(Recording& recording, cloud::Random& random) {
  recording.header.device.hold_to_run = 1;
  bool held = true;
  std::size_t change = 100;
  for (std::size_t tick = 0; tick < recording.inputs.size(); ++tick) {
    if (tick == change) {
      held = !held;
      change += held ? 100 + random.bits() % 300 : 20 + random.bits() % 80;
    }
    if (held) rewrite(recording.inputs[tick].packet, [](FalconReply& reply) { reply.buttons |= 1U; });
  }
}

struct Kind {
  const char* name;
  void (*mutate)(Recording&, cloud::Random&);
};
constexpr Kind kKinds[] = {{"wrap", wrap}, {"faults", faults}, {"settings", settings}, {"resume", resume}, {"grip", grip}};

}  // namespace

Recording mutate_packets(const Recording& recording, std::string_view name, std::uint64_t seed) {
  for (const Kind& known : kKinds) {
    if (name != known.name) continue;
    Recording mutated = recording;
    cloud::Random random(seed);
    known.mutate(mutated, random);
    return mutated;
  }
  throw InputError("there is no mutation of packets '" + std::string(name) + "'");
}

}  // namespace isotouch::motion
