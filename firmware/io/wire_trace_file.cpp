#include "firmware/io/wire_trace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <span>
#include <utility>

namespace isotouch::io {

namespace {

using device_trace_layout::kHeaderBytes;
using device_trace_layout::kRecordBytes;

constexpr std::size_t kTogether = 200 * kRecordBytes;  // so much is written at a time

std::string because(const std::string& path, const char* what, int error) { return path + ": " + what + ": " + std::strerror(error); }

}  // namespace

WireTraceWriter::~WireTraceWriter() { static_cast<void>(finish(0)); }

std::string WireTraceWriter::begin(const std::string& path, const DeviceTraceHeader& header) {
  static_cast<void>(finish(0));
  path_ = path;
  header_ = header;
  header_.run.record_count = 0;
  header_.run.blob_hash = 0;
  header_.run.flags = trace_layout::kHasOutputs;
  chain_ = DeviceChain(header_);
  failed_ = 0;
  file_ = ::open(part().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) return because(path_, "the recording cannot be written", errno);
  waiting_.assign(kHeaderBytes, 0);  // the header comes last: until then the file is none
  if (flush()) return {};
  const int why = failed_;
  static_cast<void>(finish(0));
  return because(path_, "the recording cannot be written", why);
}

std::string WireTraceWriter::append(const loop::TickRecord& tick) {
  if (!is_open()) return {};
  if (header_.run.record_count == 0) first_ns_ = tick.arrival_ns;
  DeviceTraceRecord record;
  record.input = tick.in;
  record.output = tick.out;
  record.chain = chain_.extend(tick.in, tick.out);
  record.arrival_ns = static_cast<std::uint64_t>(tick.arrival_ns > first_ns_ ? tick.arrival_ns - first_ns_ : 0);
  const DeviceTraceRecordBytes bytes = encode(record);
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  ++header_.run.record_count;
  if (waiting_.size() < kTogether || flush()) return {};
  return because(path_, "the recording ends here", failed_);
}

/// returns   false: the file takes no more, now or since before
bool WireTraceWriter::flush() {
  for (std::size_t sent = 0; sent < waiting_.size() && failed_ == 0;) {
    const ssize_t taken = ::write(file_, waiting_.data() + sent, waiting_.size() - sent);
    if (taken > 0) {
      sent += static_cast<std::size_t>(taken);
    } else if (taken == 0 || errno != EINTR) {
      failed_ = taken == 0 ? ENOSPC : errno;
    }
  }
  waiting_.clear();
  return failed_ == 0;
}

/// Where a file took no more, only it knows how much it holds: the last record may be cut.
std::uint64_t WireTraceWriter::whole_records() const {
  const off_t size = ::lseek(file_, 0, SEEK_END);
  return size < static_cast<off_t>(kHeaderBytes) ? 0 : (static_cast<std::uint64_t>(size) - kHeaderBytes) / kRecordBytes;
}

std::string WireTraceWriter::finish(std::uint64_t blob_hash) {
  if (!is_open()) return {};
  if (!flush()) header_.run.record_count = whole_records();
  header_.run.blob_hash = blob_hash;
  const std::uint64_t records = header_.run.record_count;
  const auto length = static_cast<off_t>(kHeaderBytes + records * kRecordBytes);
  const DeviceTraceHeaderBytes bytes = encode(header_);
  const bool kept = records > 0 && ::ftruncate(file_, length) == 0 &&
                    ::pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) && ::fsync(file_) == 0 &&
                    std::rename(part().c_str(), path_.c_str()) == 0;
  const int why = errno;
  ::close(std::exchange(file_, -1));
  if (!kept) std::remove(part().c_str());
  if (failed_ != 0 && kept) {
    return because(path_, ("the recording ends after " + std::to_string(records) + " ticks").c_str(), failed_) + "; make room there";
  }
  if (failed_ != 0) return because(path_, "nothing was recorded", failed_) + "; make room there";
  return kept || records == 0 ? std::string() : because(path_, "the recording cannot be completed", why);
}

std::string read_wire_trace(const std::string& path, WireTrace& trace) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) return because(path, "it cannot be read", errno);
  std::vector<std::uint8_t> bytes;
  std::uint8_t piece[1 << 16];
  for (std::size_t got = 0; (got = std::fread(piece, 1, sizeof piece, file)) > 0;) bytes.insert(bytes.end(), piece, piece + got);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) return path + ": it cannot be read; give the name of a recording";
  const auto header = decode_device_header(bytes, bytes.size());
  if (!header) return path + ": this is no recording of a device: " + describe(header.error());
  trace.header = *header;
  trace.records.clear();
  trace.records.reserve(static_cast<std::size_t>(header->run.record_count));
  for (std::size_t i = 0; i < header->run.record_count; ++i) {
    const auto at = std::span(bytes).subspan(kHeaderBytes + i * kRecordBytes);
    const auto record = decode_device_record(at.first<kRecordBytes>());
    if (!record) return path + ": record " + std::to_string(i) + ": " + describe(record.error());
    trace.records.push_back(*record);
  }
  return {};
}

}  // namespace isotouch::io
