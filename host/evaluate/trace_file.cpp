#include "host/evaluate/trace_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <utility>

#include "host/error.h"
#include "shared/bytes.h"
#include "shared/hash64.h"

namespace isotouch::evaluate {

using namespace trace_layout;

namespace {

constexpr std::size_t kOutputBegin = 16;
constexpr std::size_t kOutputEnd = 64;
constexpr std::size_t kChainAt = 56;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) { throw InputError(file.string() + ": " + what); }

void write_bytes(std::ofstream& out, const std::uint8_t* data, std::size_t size) {
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

}  // namespace

Trace Trace::read(const std::filesystem::path& file) {
  std::error_code failed;
  const std::uint64_t file_bytes = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) refuse(file, "cannot be read as a trace file; check the path and its permissions");

  std::array<std::uint8_t, kHeaderBytes> head{};
  in.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  const auto got = static_cast<std::size_t>(in.gcount());
  const Result<TraceHeader> header = decode_header({head.data(), got}, file_bytes);
  if (!header) refuse(file, std::string("not usable as a trace: ") + describe(header.error()) + "; make or record it again");

  Trace trace;
  trace.file_ = file;
  trace.header_ = *header;
  trace.bytes_.resize(file_bytes - kHeaderBytes);
  in.read(reinterpret_cast<char*>(trace.bytes_.data()), static_cast<std::streamsize>(trace.bytes_.size()));
  if (static_cast<std::size_t>(in.gcount()) != trace.bytes_.size()) refuse(file, "changed while it was read; try again");

  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const std::uint8_t* bytes = trace.at(tick);
    const std::string place = "record " + std::to_string(tick) + " at byte " + std::to_string(kHeaderBytes + tick * kRecordBytes);
    if (!decode_record(std::span<const std::uint8_t, kRecordBytes>(bytes, kRecordBytes))) {
      refuse(file, place + " holds an undefined value (buttons, freshness, age or reserved bytes); make or record the trace again");
    }
    if (!trace.header_.has_outputs() && std::any_of(bytes + kOutputBegin, bytes + kOutputEnd, [](std::uint8_t b) { return b != 0; })) {
      refuse(file, place + " holds an output though the header says that none are recorded; make or record the trace again");
    }
  }
  return trace;
}

TraceRecord Trace::record(std::size_t tick) const {
  return *decode_record(std::span<const std::uint8_t, kRecordBytes>(at(tick), kRecordBytes));
}

std::uint64_t Trace::chain(std::size_t tick) const { return load_le<std::uint64_t>(at(tick) + kChainAt); }

bool Trace::chain_follows(std::size_t tick) const {
  const std::uint64_t before = tick == 0 ? Chain(header_, header_.blob_hash).value() : chain(tick - 1);
  return chain(tick) == hash64(at(tick), kRecordChainBytes, before);
}

TraceWriter::TraceWriter(std::filesystem::path file, const TraceHeader& header)
    : file_(std::move(file)), part_(file_.string() + ".part"), header_(header) {
  header_.record_count = 0;
  out_.open(part_, std::ios::binary | std::ios::trunc);
  if (!out_) refuse(file_, "cannot be written; check that the folder exists and is writable");
  write_bytes(out_, encode(header_).data(), kHeaderBytes);
}

TraceWriter::~TraceWriter() {
  if (finished_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void TraceWriter::append(const TraceRecord& record) {
  write_bytes(out_, encode(record).data(), kRecordBytes);
  ++header_.record_count;
}

void TraceWriter::finish() {
  out_.seekp(0);
  write_bytes(out_, encode(header_).data(), kHeaderBytes);
  out_.close();
  std::error_code failed;
  if (out_) std::filesystem::rename(part_, file_, failed);
  if (!out_ || failed) refuse(file_, "could not be written to its end; check the free space and the permissions");
  finished_ = true;
}

}  // namespace isotouch::evaluate
