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

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) { throw InputError(file.string() + ": " + what); }

constexpr std::size_t kPendingBytes = 1 << 16;

void write_bytes(std::ofstream& out, const std::uint8_t* data, std::size_t size) {
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

/// A whole trace of the other kind is no broken file, only in the wrong place.
const char* other_kind(std::span<const std::uint8_t> bytes, std::uint16_t expected) {
  const Result<std::uint16_t> major = isotouch::trace_major(bytes);
  if (!major || *major == expected) return nullptr;
  if (*major == WireFormat::kMajor)
    return "holds a device's packets, not positions of the hand; replay, trace diff, render and scan take such a trace";
  if (*major == HipFormat::kMajor) return "holds positions of the hand, not a device's packets; give two traces of one kind";
  return nullptr;
}

}  // namespace

std::uint16_t trace_major(const std::filesystem::path& file) {
  std::array<std::uint8_t, 6> head{};
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  if (in.gcount() == 0) refuse(file, "cannot be read as a trace file; check the path and its permissions");
  const Result<std::uint16_t> major = isotouch::trace_major(std::span(head.data(), static_cast<std::size_t>(in.gcount())));
  if (!major) refuse(file, std::string("not usable as a trace: ") + describe(major.error()) + "; make or record it again");
  return *major;
}

template <class Format>
TraceFile<Format> TraceFile<Format>::read(const std::filesystem::path& file) {
  std::error_code failed;
  const std::uint64_t file_bytes = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) refuse(file, "cannot be read as a trace file; check the path and its permissions");

  std::array<std::uint8_t, Format::kHeaderBytes> head{};
  in.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  const std::span<const std::uint8_t> got(head.data(), static_cast<std::size_t>(in.gcount()));
  if (const char* wrong = other_kind(got, Format::kMajor)) refuse(file, wrong);
  const Result<typename Format::Header> header = Format::decode(got, file_bytes);
  if (!header) refuse(file, std::string("not usable as a trace: ") + describe(header.error()) + "; make or record it again");

  TraceFile trace;
  trace.file_ = file;
  trace.header_ = *header;
  trace.bytes_.resize(file_bytes - Format::kHeaderBytes);
  in.read(reinterpret_cast<char*>(trace.bytes_.data()), static_cast<std::streamsize>(trace.bytes_.size()));
  if (static_cast<std::size_t>(in.gcount()) != trace.bytes_.size()) refuse(file, "changed while it was read; try again");

  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const std::uint8_t* bytes = trace.at(tick);
    const std::string place =
        "record " + std::to_string(tick) + " at byte " + std::to_string(Format::kHeaderBytes + tick * Format::kRecordBytes);
    if (!Format::decode(std::span<const std::uint8_t, Format::kRecordBytes>(bytes, Format::kRecordBytes))) {
      refuse(file, place + " holds an undefined value (buttons, freshness, age or reserved bytes); make or record the trace again");
    }
    const auto is_set = [](std::uint8_t b) { return b != 0; };
    if (!trace.header_.has_outputs() && std::any_of(bytes + Format::kOutputAt, bytes + Format::kChainAt + 8, is_set)) {
      refuse(file, place + " holds an output though the header says that none are recorded; make or record the trace again");
    }
  }
  return trace;
}

template <class Format>
TraceFile<Format>::TraceFile(std::filesystem::path file, const typename Format::Header& header,
                             std::span<const typename Format::Record> records)
    : file_(std::move(file)), header_(header) {
  Format::run(header_).record_count = records.size();
  bytes_.reserve(records.size() * Format::kRecordBytes);
  for (const typename Format::Record& record : records) {
    const auto bytes = encode(record);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
}

template <class Format>
typename Format::Record TraceFile<Format>::record(std::size_t tick) const {
  return *Format::decode(std::span<const std::uint8_t, Format::kRecordBytes>(at(tick), Format::kRecordBytes));
}

template <class Format>
std::uint64_t TraceFile<Format>::chain(std::size_t tick) const {
  return load_le<std::uint64_t>(at(tick) + Format::kChainAt);
}

template <class Format>
bool TraceFile<Format>::chain_follows(std::size_t tick) const {
  const std::uint64_t before = tick == 0 ? Format::first_chain(header_) : chain(tick - 1);
  return chain(tick) == hash64(at(tick), Format::kChainAt, before);
}

template <class Format>
TraceFileWriter<Format>::TraceFileWriter(std::filesystem::path file, const typename Format::Header& header)
    : file_(std::move(file)), part_(file_.string() + ".part"), header_(header) {
  Format::run(header_).record_count = 0;
  out_.rdbuf()->pubsetbuf(nullptr, 0);
  out_.open(part_, std::ios::binary | std::ios::trunc);
  if (!out_) refuse(file_, "cannot be written; check that the folder exists and is writable");
  write_bytes(out_, encode(header_).data(), Format::kHeaderBytes);
}

template <class Format>
TraceFileWriter<Format>::~TraceFileWriter() {
  if (finished_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

template <class Format>
void TraceFileWriter<Format>::append(const typename Format::Record& record) {
  const auto bytes = encode(record);
  pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  chain_ = record.chain;
  ++Format::run(header_).record_count;
  if (pending_.size() >= kPendingBytes) write_pending();
}

template <class Format>
void TraceFileWriter<Format>::write_pending() {
  write_bytes(out_, pending_.data(), pending_.size());
  pending_.clear();
}

template <class Format>
void TraceFileWriter<Format>::finish() {
  write_pending();
  out_.seekp(0);
  write_bytes(out_, encode(header_).data(), Format::kHeaderBytes);
  out_.close();
  std::error_code failed;
  if (out_) std::filesystem::rename(part_, file_, failed);
  if (!out_ || failed) refuse(file_, "could not be written to its end; check the free space and the permissions");
  finished_ = true;
}

template <class Format>
typename TraceFileWriter<Format>::Kept TraceFileWriter<Format>::finish_with_what_fits() {
  std::uint64_t& count = Format::run(header_).record_count;
  write_pending();
  if (is_full()) {
    std::error_code failed;
    const std::uint64_t bytes = std::filesystem::file_size(part_, failed);
    const std::uint64_t fit = failed || bytes < Format::kHeaderBytes ? 0 : (bytes - Format::kHeaderBytes) / Format::kRecordBytes;
    if (fit == 0) refuse(file_, "not one record could be written; check the free space");
    count = std::min(count, fit);
    const std::uint64_t end = Format::kHeaderBytes + count * Format::kRecordBytes;
    std::filesystem::resize_file(part_, end, failed);
    std::array<std::uint8_t, 8> chain{};
    std::ifstream in(part_, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(end - Format::kRecordBytes + Format::kChainAt));
    in.read(reinterpret_cast<char*>(chain.data()), chain.size());
    if (failed || !in) refuse(file_, "could neither be written to its end nor cut; check the disk");
    chain_ = load_le<std::uint64_t>(chain.data());
    out_.close();
    out_.open(part_, std::ios::binary | std::ios::in | std::ios::out);
  }
  finish();
  return {count, chain_};
}

template class TraceFile<HipFormat>;
template class TraceFile<WireFormat>;
template class TraceFileWriter<HipFormat>;
template class TraceFileWriter<WireFormat>;

}  // namespace isotouch::evaluate
