/// The doors for recordings: what is read is written back to the same bytes, and replays.
#include <algorithm>
#include <cmath>

#include "firmware/core/render.h"
#include "firmware/core/tick.h"
#include "shared/crc32.h"
#include "shared/trace.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

const BlobView& ball() {
  static const test::FieldImage image({48, 48, 48}, [](const test::Point& p) { return length(p - test::Point{24, 24, 24}) - 15; });
  return image.view();
}

template <std::size_t kChecksumAt>
void seal(std::span<std::uint8_t> bytes) {
  store_le(bytes.data() + kChecksumAt, crc32(bytes.data(), kChecksumAt));
}

template <class Record, std::size_t kBytes, class Decode, class Step>
void walk(std::span<const std::uint8_t> records, Decode decode, Step step) {
  for (; records.size() >= kBytes; records = records.subspan(kBytes)) {
    const Result<Record> record = decode(std::span<const std::uint8_t, kBytes>(records.data(), kBytes));
    if (!record) return;
    const auto written = encode(*record);
    fuzz::hold(std::equal(written.begin(), written.end(), records.begin()), "a record that is read is written as it was");
    step(*record);
  }
}

void at_hip(std::span<std::uint8_t> bytes) {
  using namespace trace_layout;
  if (bytes.size() < kHeaderBytes) return;
  seal<92>(bytes);
  const Result<TraceHeader> header = decode_header(bytes, bytes.size());
  if (!header) return;
  const core::RenderModel model = core::make_render_model(header->settings, header->period_ns, ball());
  core::RenderState state;
  walk<TraceRecord, kRecordBytes>(
      bytes.subspan(kHeaderBytes), [](auto b) { return decode_record(b); },
      [&](const TraceRecord& record) { core::render(record.input, ball(), model, state); });
}

void at_wire(std::span<std::uint8_t> bytes) {
  using namespace trace_layout;
  if (bytes.size() < kHeaderBytes) return;
  DeviceModelBytes model_bytes{};
  std::copy_n(bytes.begin() + kModelAt, model_bytes.size(), model_bytes.begin());
  if (const Result<DeviceModel> device = decode_model(model_bytes)) store_le(bytes.data() + 32, hash(*device));
  seal<kChecksumAt>(bytes);
  const Result<TraceHeader> header = decode_header(bytes, bytes.size());
  if (!header) return;
  const core::TickModel model = core::make_tick_model(header->device, header->settings, header->period_ns);
  core::TickState state;
  walk<TraceRecord, kRecordBytes>(
      bytes.subspan(kHeaderBytes), [](auto b) { return decode_record(b); },
      [&](const TraceRecord& record) { core::tick(record.input, record.input.field_generation == 0 ? nullptr : &ball(), model, state); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Copy copy(data, size);
  const Result<std::uint16_t> major = trace_major(copy.bytes());
  if (major) *major == trace_layout::kMajor ? at_wire(copy.bytes()) : at_hip(copy.bytes());
  return 0;
}
