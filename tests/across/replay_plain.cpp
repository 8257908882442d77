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
#include <string>
#include <vector>

#include "firmware/core/tick.h"
#include "shared/blob.h"
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

int replay(const char* blob_name, const char* trace_name) {
  const Image blob(read_file(blob_name)), trace(read_file(trace_name));
  const Result<BlobView> field = BlobView::parse(blob.span());
  if (!field) return refuse(blob_name, describe(field.error()));
  const Result<TraceHeader> header = decode_header(trace.span(), trace.bytes);
  if (!header) return refuse(trace_name, describe(header.error()));
  if (!header->has_outputs()) return refuse(trace_name, describe(Error::kNoOutputs));
  if (header->blob_hash != field->hash()) return refuse(trace_name, describe(Error::kWrongBlob));

  const core::TickModel model = core::make_model(header->settings, header->period_ns, *field);
  core::TickState state;
  Chain chain(*header, header->blob_hash);
  std::string first_difference = "null";
  const auto started = std::chrono::steady_clock::now();
  const std::uint8_t* at = trace.span().data() + trace_layout::kHeaderBytes;
  for (std::uint64_t n = 0; n < header->record_count; ++n, at += trace_layout::kRecordBytes) {
    const Result<TraceRecord> record =
        decode_record(std::span<const std::uint8_t, trace_layout::kRecordBytes>(at, trace_layout::kRecordBytes));
    if (!record) return refuse(trace_name, describe(record.error()));
    const TickOutput output = core::tick(record->input, *field, model, state);
    const bool equal = chain.extend(record->input, output) == record->chain && output == record->output;
    if (!equal && first_difference == "null") first_difference = std::to_string(n);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  std::printf("{\"ticks\": %llu, \"seconds\": %.3f, \"hash\": \"%016llx\", \"first_difference\": %s}\n",
              static_cast<unsigned long long>(header->record_count), seconds, static_cast<unsigned long long>(chain.value()),
              first_difference.c_str());
  return first_difference == "null" ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: replay_plain BLOB TRACE\n");
    return 2;
  }
  return replay(argv[1], argv[2]);
}
