#include "shared/files/trace_file.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "shared/bytes.h"
#include "shared/hash64.h"

namespace isotouch::files {

using namespace trace_layout;

namespace {

struct Closed {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// returns   false: it cannot be read
bool read_bytes(const std::string& path, std::vector<std::uint8_t>& bytes) {
  const std::unique_ptr<std::FILE, Closed> file(std::fopen(path.c_str(), "rbe"));
  if (!file) return false;
  std::vector<std::uint8_t> piece(1U << 16);
  for (std::size_t got = 0; (got = std::fread(piece.data(), 1, piece.size(), file.get())) > 0;) {
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
  }
  return std::ferror(file.get()) == 0;
}

}  // namespace

TraceFile::TraceFile(std::string path, const TraceHeader& header, std::span<const TraceRecord> records)
    : path_(std::move(path)), header_(header) {
  header_.record_count = records.size();
  bytes_.reserve(records.size() * kRecordBytes);
  for (const TraceRecord& record : records) {
    const TraceRecordBytes bytes = encode(record);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
}

std::span<const std::uint8_t, kRecordBytes> TraceFile::at(std::size_t tick) const {
  return std::span<const std::uint8_t, kRecordBytes>(bytes_.data() + tick * kRecordBytes, kRecordBytes);
}

TraceRecord TraceFile::record(std::size_t tick) const { return *decode_record(at(tick)); }

std::uint64_t TraceFile::chain(std::size_t tick) const { return load_le<std::uint64_t>(at(tick).data() + kChainAt); }

bool TraceFile::chain_follows(std::size_t tick) const {
  const std::uint64_t before = tick == 0 ? Chain(header_).value() : chain(tick - 1);
  return chain(tick) == hash64(at(tick).data(), kChainAt, before);
}

/// Keeps the records that are whole and follow from each other.
void TraceFile::drop_what_is_torn(std::uint64_t promised) {
  std::size_t whole = 0;
  while (whole < size() && decode_record(at(whole)) && (!header_.has_outputs || chain_follows(whole))) ++whole;
  bytes_.resize(whole * kRecordBytes);
  header_.record_count = whole;
  const std::string missing =
      promised == kUnfinished ? "it is not known how many are missing" : std::to_string(promised - whole) + " ticks are missing";
  cut_off_ = path_ + ": the recording was cut off; it holds " + std::to_string(whole) + " whole ticks; " + missing;
}

Refusal read_trace(const std::string& path, TraceFile& trace) {
  std::vector<std::uint8_t> bytes;
  if (!read_bytes(path, bytes)) return path + ": cannot be read as a trace; check the path and its permissions";
  Result<TraceHeader> header = decode_header(bytes, bytes.size());
  const bool is_cut = !header && header.error() == Error::kTruncated && bytes.size() >= kHeaderBytes + kRecordBytes;
  if (is_cut) header = decode_header(bytes);
  if (!header) return path + ": not usable as a trace: " + describe(header.error()) + "; make or record it again";
  trace.path_ = path;
  trace.header_ = *header;
  trace.bytes_.assign(bytes.begin() + kHeaderBytes, bytes.end());
  trace.cut_off_.clear();
  trace.damage_.clear();
  if (is_cut) trace.drop_what_is_torn(header->record_count);
  if (is_cut && trace.size() == 0) return path + ": was cut off before its first tick; record it again";
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const auto at = trace.at(tick);
    const std::string place = path + ": record " + std::to_string(tick) + " at byte " + std::to_string(kHeaderBytes + tick * kRecordBytes);
    const Result<TraceRecord> record = decode_record(at);
    if (!record) return place + " holds an undefined value; make or record the trace again";
    if (record->input.kind != trace.kind()) return place + " holds another kind of input than the first; make or record the trace again";
    if (!header->has_outputs && (record->output != Output{} || record->chain != 0)) {
      return place + " holds an output, but the header says that there are none; make or record the trace again";
    }
    if (header->has_outputs && trace.damage_.empty() && !trace.chain_follows(tick)) {
      trace.damage_ = path + ": the chain breaks at record " + std::to_string(tick) +
                      ": its bytes were changed after they were recorded; use the original file";
    }
  }
  return {};
}

}  // namespace isotouch::files
