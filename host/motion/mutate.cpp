#include "host/motion/mutate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "host/error.h"
#include "host/motion/hand.h"
#include "host/motion/mutate_hand.h"
#include "host/motion/mutate_packets.h"

namespace isotouch::motion {

namespace {

constexpr InputKind kHand = InputKind::kPosition, kDevice = InputKind::kPacket;

constexpr std::array<Mutation, 12> kMutations = {{
    {"fast", kHand, false, "the motion is scaled in time: its fastest touch, or without a touch its fastest moment, has 1 m/s"},
    {"mirror", kHand, true, "mirrored at the middle of the object's grid, along an axis that the seed chooses"},
    {"jitter", kHand, true, "every sample moved by up to an encoder count along each axis, about six percent lost"},
    {"dwell", kHand, false, "where the surface is bent most, the hand presses, rests with flickering counts, and moves a little"},
    {"medial", kHand, false, "where the object is thinnest, the hand crosses its middle to and fro, then along it"},
    {"graze", kHand, true, "near the surface the hand follows it, within a tenth of a voxel in and out"},
    {"leave", kHand, false, "six times the hand leaves the grid from a touch and comes back, three times from beyond ±512 mm"},
    {"wrap", kDevice, true, "the encoders' 16 bits wrap in the middle of the motion"},
    {"faults", kDevice, true, "missing and malformed packets, late ticks, stops, lines, jumps, lost homing, power cuts, restarts"},
    {"settings", kDevice, true, "every 40 to 200 ticks one of the settings that may change takes a random value"},
    {"resume", kDevice, true, "every 200 to 300 ticks a person resumes, whatever the state is"},
    {"grip", kDevice, true, "the device gives force only while a button is held, and the hand lets it go now and then"},
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
  const bool is_patched =
      std::any_of(recording.inputs.begin(), recording.inputs.end(), [](const Input& in) { return (in.requests & kRequestMoved) != 0; });
  if (is_patched && !mutation->keeps_ticks) {
    throw InputError("its field was patched meanwhile, and '" + std::string(name) +
                     "' changes how many ticks there are, so the patches would come at other moments; choose mirror, jitter or graze");
  }
  Recording mutated{recording.header, {}};
  mutate_hand(recording.inputs, field, {std::string(name), seed, recording.header.period_ns},
              [&](const Input& input) { mutated.inputs.push_back(input); });
  for (std::size_t tick = 0; is_patched && tick < mutated.inputs.size(); ++tick) keep_field(recording.inputs[tick], mutated.inputs[tick]);
  return mutated;
}

}  // namespace isotouch::motion
