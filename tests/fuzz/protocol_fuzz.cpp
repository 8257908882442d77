/// The door of the control socket: frames and what their bodies say.
#include <array>

#include "shared/crc32.h"
#include "shared/protocol_messages.h"
#include "tests/fuzz/input.h"

using namespace isotouch;
using namespace isotouch::protocol;

namespace {

/// A message that is read may be written, and then says the same.
template <class Message>
void read(const Frame& frame) {
  const Result<Message> message = decode<Message>(frame.body);
  if (!message) return;
  static std::array<std::uint8_t, kMaxFrame> first, second;
  const std::size_t size = encode(frame.kind, *message, first);
  fuzz::hold(size <= frame.size, "a message is never longer than the body that it was read from");
  const Result<Frame> again = read_frame({first.data(), size});
  fuzz::hold(again && again->size == size, "a frame that is written can be read");
  const Result<Message> same = decode<Message>(again->body);
  fuzz::hold(same && encode(frame.kind, *same, second) == size && std::memcmp(first.data(), second.data(), size) == 0,
             "a message is read as it was written");
}

void read_body(const Frame& frame) {
  switch (frame.kind) {
    case Kind::kHello: return read<Hello>(frame);
    case Kind::kBegin: return read<Begin>(frame);
    case Kind::kBeginPatch: return read<BeginPatch>(frame);
    case Kind::kChunk: return read<Chunk>(frame);
    case Kind::kHistogram: return read<HistogramRequest>(frame);
    case Kind::kSubscribe: return read<Subscribe>(frame);
    case Kind::kSelect: return read<Select>(frame);
    case Kind::kCalibrate: return read<Calibrate>(frame);
    case Kind::kSet: return read<Set>(frame);
    case Kind::kWelcome: return read<Welcome>(frame);
    case Kind::kAccepted: return read<Accepted>(frame);
    case Kind::kStatusReport: return read<StatusReport>(frame);
    case Kind::kHistogramReport: return read<HistogramReport>(frame);
    case Kind::kRecording: return read<Recording>(frame);
    case Kind::kFieldList: return read<FieldList>(frame);
    case Kind::kDeviceReport: return read<DeviceReport>(frame);
    case Kind::kPostureReport: return read<PostureReport>(frame);
    case Kind::kRecords: return read<Records>(frame);
    case Kind::kRefused: return read<Refusal>(frame);
    default: return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Copy copy(data, size);
  auto stream = copy.bytes();
  static_cast<void>(read_frame(stream));  // as it came
  while (stream.size() >= kHeaderBytes) {
    const auto body = std::min<std::size_t>(load_le<std::uint32_t>(stream.data() + kLengthAt), stream.size() - kHeaderBytes);
    seal_frame(static_cast<Kind>(stream[kKindAt]), std::min(body, kMaxBody), stream);
    const Result<Frame> frame = read_frame(stream);
    fuzz::hold(frame && frame->size >= kHeaderBytes, "a sealed frame can be read");
    read_body(*frame);
    stream = stream.subspan(frame->size);
  }
  return 0;
}
