#include "host/motion/mutate.h"

#include <array>
#include <string>

#include "host/error.h"
#include "host/motion/mutate_hand.h"
#include "host/motion/mutate_packets.h"

namespace isotouch::motion {

namespace {

constexpr InputKind kHand = InputKind::kPosition, kDevice = InputKind::kPacket;

constexpr std::array<Mutation, 12> kMutations = {{
    {"fast", kHand, "the motion runs faster: its fastest touch, or without a touch its fastest moment, has 1 m/s"},
    {"mirror", kHand, "mirrored at the middle of the object's grid, along an axis that the seed chooses"},
    {"jitter", kHand, "every sample moved by up to an encoder count along each axis, about six percent lost"},
    {"dwell", kHand, "where the surface is bent most, the hand presses, rests with flickering counts, and moves a little"},
    {"medial", kHand, "where the object is thinnest, the hand crosses its middle to and fro, then along it"},
    {"graze", kHand, "near the surface the hand follows it, within a tenth of a voxel in and out"},
    {"leave", kHand, "six times the hand leaves the grid from a touch and comes back, three times from beyond ±512 mm"},
    {"wrap", kDevice, "the encoders' 16 bits wrap in the middle of the motion"},
    {"faults", kDevice, "missing and malformed packets, late ticks, stops, lines, jumps, lost homing, power cuts, restarts"},
    {"settings", kDevice, "every 40 to 200 ticks one of the settings that may change takes a random value"},
    {"resume", kDevice, "every 200 to 300 ticks a person resumes, whatever the state is"},
    {"grip", kDevice, "the device gives force only while a button is held, and the hand lets it go now and then"},
}};

}  // namespace

std::span<const Mutation> mutations() { return kMutations; }

const Mutation* find_mutation(std::string_view name) {
  for (const Mutation& mutation : kMutations) {
    if (mutation.name == name) return &mutation;
  }
  return nullptr;
}

Recording mutate(const Recording& recording, std::string_view name, const FieldView& field, std::uint64_t seed) {
  const Mutation* mutation = find_mutation(name);
  if (mutation == nullptr) throw InputError("there is no mutation '" + std::string(name) + "'");
  if (mutation->of == kDevice) return mutate_packets(recording, name, seed);
  Recording mutated{recording.header, {}};
  mutate_hand(recording.inputs, field, {std::string(name), seed, recording.header.period_ns},
              [&](const Input& input) { mutated.inputs.push_back(input); });
  return mutated;
}

}  // namespace isotouch::motion
