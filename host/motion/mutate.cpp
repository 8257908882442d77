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
    {"fast", kHand, "time runs so that the fastest touch, or without one the fastest moment, has 1 m/s"},
    {"mirror", kHand, "mirrored on the middle of the object's grid, along an axis that the seed draws"},
    {"jitter", kHand, "every sample moved by up to an encoder count along each axis, three in a hundred lost"},
    {"dwell", kHand, "where the surface is bent most, the hand presses, rests with flickering counts, and stirs"},
    {"medial", kHand, "where the object is thinnest, the hand crosses its middle to and fro, then along it"},
    {"graze", kHand, "near the surface the hand follows it, within a tenth of a voxel in and out"},
    {"leave", kHand, "six times the hand leaves the grid out of a touch, three times also ±512 mm, and comes back"},
    {"wrap", kDevice, "the encoders' 16 bits wrap in the middle of the motion"},
    {"faults", kDevice, "missing and malformed packets, late ticks, stops, lines, jumps, lost homing, power cuts, restarts"},
    {"settings", kDevice, "every 40 to 200 ticks one of the settings that may change takes a drawn value"},
    {"resume", kDevice, "every 200 to 300 ticks a person resumes, whatever there was"},
    {"grip", kDevice, "the device gives forces only while a button is held, which it is not always"},
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
