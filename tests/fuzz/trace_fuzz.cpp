/// The doors for recordings: what is read is written back to the same bytes, and replays.
#include <algorithm>
#include <cmath>

#include "firmware/core/tick.h"
#include "shared/crc32.h"
#include "shared/trace.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

const FieldView& ball() {
  static const test::FieldImage image({48, 48, 48}, [](const test::Point& p) { return length(p - test::Point{24, 24, 24}) - 15; });
  return image.view();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trace_layout;
  if (size < kHeaderBytes) return 0;
  fuzz::Copy copy(data, size);
  std::span<std::uint8_t> bytes = copy.bytes();
  store_le(bytes.data() + kChecksumAt, crc32(bytes.data(), kChecksumAt));  // a fuzzer finds no checksum; a person who means harm does
  const Result<TraceHeader> header = decode_header(bytes, bytes.size());
  if (!header) return 0;
  const core::TickModel tick_model = core::make_tick_model(header->device, header->settings, header->period_ns);
  const core::PositionModel position_model = core::make_position_model(header->device, header->settings, header->period_ns, ball());
  core::TickState tick_state;
  core::PositionState position_state;
  for (auto records = bytes.subspan(kHeaderBytes); records.size() >= kRecordBytes; records = records.subspan(kRecordBytes)) {
    const Result<TraceRecord> record = decode_record(std::span<const std::uint8_t, kRecordBytes>(records.data(), kRecordBytes));
    if (!record) return 0;
    const TraceRecordBytes written = encode(*record);
    fuzz::hold(std::equal(written.begin(), written.end(), records.begin()), "a record that is read is written as it was");
    const Input& in = record->input;
    if (in.kind == InputKind::kPosition) {
      core::render_position(in, ball(), position_model, position_state);
    } else {
      core::tick(in, in.field_generation == 0 ? nullptr : &ball(), tick_model, tick_state);
    }
  }
  return 0;
}
