/// The door for recordings of ROS 2 and Foxglove: MCAP from memory, and every type of message in both of its forms.
#include <array>
#include <string>

#include "host/bag/mcap_reader.h"
#include "host/bag/ros_message.h"
#include "host/error.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  const auto hold_finite = [](const bag::Channel& channel, std::span<const std::uint8_t> message) {
    const auto measured = bag::read_message(channel, message);
    fuzz::hold(!measured || measured->value.allFinite(), "numbers are finite");
  };
  try {
    bag::read_mcap(bytes, "bag.mcap",
                   {[&](const bag::Channel& channel, std::uint64_t, std::span<const std::uint8_t> message) {
                      if (bag::content_of(channel) != bag::Content::kNothing) hold_finite(channel, message);
                    },
                    {}});
  } catch (const InputError&) {  // refused with a sentence
  }
  for (const char* type : {"geometry_msgs/msg/PointStamped", "geometry_msgs/msg/TransformStamped", "geometry_msgs/msg/Wrench"}) {
    for (const char* encoding : {"cdr", "json"}) hold_finite({"/a", type, encoding}, bytes);
  }
  return 0;
}
