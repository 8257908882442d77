/// A replay with nothing but shared/ and firmware/core, as SPEC.md states it: for processors and compilers that have no host tool.
///
///     replay_plain BLOB TRACE
///
/// Prints {"ticks", "seconds", "hash", "first_difference"} as `isotouch replay --json` does, the difference as a tick number. Exit codes as the
/// tool's: 0 equal to what was recorded, 1 bad input, 2 wrong usage, 3 different.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "firmware/core/device_tick.h"
#include "firmware/core/tick.h"
#include "shared/blob.h"
#include "shared/device_trace.h"
#include "shared/trace.h"

namespace {

using namespace isotouch;

std::vector<char> read_file(const char* name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The file's bytes behind an 8-byte boundary.
struct Image {
  explicit Image(const std::vector<char>& file) : words((file.size() + 7) / 8), bytes(file.size()) {
    if (!file.empty()) std::memcpy(words.data(), file.data(), file.size());
  }
  std::span<const std::uint8_t> span() const { return {reinterpret_cast<const std::uint8_t*>(words.data()), bytes}; }

  std::vector<std::uint64_t> words;
  std::size_t bytes;
};

int refuse(const char* file, const char* why) {
  std::fprintf(stderr, "replay_plain: %s: %s\n", file, why);
  return 1;
}

/// How each major version is read and run; see SPEC.md, sections 3 and 5.
struct Hip {
  static constexpr std::size_t kHeaderBytes = trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = trace_layout::kRecordBytes;
  static Result<TraceHeader> decode(const Image& trace) { return decode_header(trace.span(), trace.bytes); }
  static Result<TraceRecord> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_record(bytes); }
  static const TraceHeader& run(const TraceHeader& header) { return header; }
  static bool may_be_of(const TraceHeader& run, std::uint64_t blob) { return run.blob_hash == blob; }

  Hip(const BlobView& blob, const TraceHeader& header)
      : field(blob), model(core::make_model(header.settings, header.period_ns, blob)), chain(header, header.blob_hash) {}
  TickOutput step(const TickInput& in) { return core::tick(in, field, model, state); }

  const BlobView& field;
  core::TickModel model;
  core::TickState state;
  Chain chain;
};

struct Wire {
  static constexpr std::size_t kHeaderBytes = device_trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = device_trace_layout::kRecordBytes;
  static Result<DeviceTraceHeader> decode(const Image& trace) { return decode_device_header(trace.span(), trace.bytes); }
  static Result<DeviceTraceRecord> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_device_record(bytes); }
  static const TraceHeader& run(const DeviceTraceHeader& header) { return header.run; }
  static bool may_be_of(const TraceHeader& run, std::uint64_t blob) { return run.blob_hash == blob || run.blob_hash == 0; }

  Wire(const BlobView& blob, const DeviceTraceHeader& header)
      : field(blob), model(core::make_device_model(header.device, header.run.settings, header.run.period_ns)), chain(header) {}
  DeviceOutput step(const DeviceInput& in) { return core::device_tick(in, in.field_generation == 0 ? nullptr : &field, model, state); }

  const BlobView& field;
  core::DeviceTickModel model;
  core::DeviceState state;
  DeviceChain chain;
};

template <class Kind>
int replay(const BlobView& field, const Image& trace, const char* trace_name) {
  const auto header = Kind::decode(trace);
  if (!header) return refuse(trace_name, describe(header.error()));
  const TraceHeader& run = Kind::run(*header);
  if (!run.has_outputs()) return refuse(trace_name, describe(Error::kNoOutputs));
  if (!Kind::may_be_of(run, field.hash())) return refuse(trace_name, describe(Error::kWrongBlob));

  Kind kind(field, *header);
  std::string first_difference = "null";
  const auto started = std::chrono::steady_clock::now();
  const std::uint8_t* at = trace.span().data() + Kind::kHeaderBytes;
  for (std::uint64_t n = 0; n < run.record_count; ++n, at += Kind::kRecordBytes) {
    const auto record = Kind::decode(std::span<const std::uint8_t, Kind::kRecordBytes>(at, Kind::kRecordBytes));
    if (!record) return refuse(trace_name, describe(record.error()));
    const auto output = kind.step(record->input);
    const bool equal = kind.chain.extend(record->input, output) == record->chain && output == record->output;
    if (!equal && first_difference == "null") first_difference = std::to_string(n);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  std::printf("{\"ticks\": %llu, \"seconds\": %.3f, \"hash\": \"%016llx\", \"first_difference\": %s}\n",
              static_cast<unsigned long long>(run.record_count), seconds, static_cast<unsigned long long>(kind.chain.value()),
              first_difference.c_str());
  return first_difference == "null" ? 0 : 3;
}

int replay(const char* blob_name, const char* trace_name) {
  const Image blob(read_file(blob_name)), trace(read_file(trace_name));
  const Result<BlobView> field = BlobView::parse(blob.span());
  if (!field) return refuse(blob_name, describe(field.error()));
  const Result<std::uint16_t> major = trace_major(trace.span());
  if (!major) return refuse(trace_name, describe(major.error()));
  return *major == device_trace_layout::kMajor ? replay<Wire>(*field, trace, trace_name) : replay<Hip>(*field, trace, trace_name);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: replay_plain BLOB TRACE\n");
    return 2;
  }
  return replay(argv[1], argv[2]);
}
