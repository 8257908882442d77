/// The door for the device: packets as they come.
#include "firmware/core/reply_reader.h"
#include "shared/falcon_packet.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  core::ReplyState state;
  const DeviceModel model = libnifalcon_model();
  fuzz::Front front(data, size);
  while (!front.empty()) {
    Input in;
    for (std::uint8_t& byte : in.packet) byte = front.take<std::uint8_t>();
    in.fresh = (in.packet[14] & 1U) != 0;
    if (const Result<FalconReply> reply = decode_reply(in.packet)) {
      const FalconPacket written = encode(*reply);
      const Result<FalconReply> again = decode_reply(written);
      fuzz::hold(again && *again == *reply, "a reply is read as it was written");
    }
    if (const Result<FalconCommand> command = decode_command(in.packet)) {
      const Result<FalconCommand> again = decode_command(encode(*command));
      fuzz::hold(again && *again == *command, "a command is read as it was written");
    }
    const core::Reading reading = core::read_reply(in, model, state);
    fuzz::hold(!(reading.fresh && reading.malformed), "a packet is new or malformed, not both");
  }
  return 0;
}
