#include "firmware/io/wire_trace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>

namespace isotouch::io {

namespace {

std::string because(const std::string& path, const char* what) { return path + ": " + what + ": " + std::strerror(errno); }

}  // namespace

WireTraceWriter::~WireTraceWriter() { finish(0); }

std::string WireTraceWriter::begin(const std::string& path, const DeviceTraceHeader& header) {
  finish(0);
  path_ = path;
  header_ = header;
  header_.run.record_count = 0;
  header_.run.blob_hash = 0;
  header_.run.flags = trace_layout::kHasOutputs;
  chain_ = DeviceChain(header_);
  file_ = std::fopen(part().c_str(), "wbe");
  if (file_ == nullptr) return because(path_, "the recording cannot be written");
  const DeviceTraceHeaderBytes place{};  // the header comes last: until then the file is none
  if (std::fwrite(place.data(), 1, place.size(), file_) != place.size()) return because(path_, "the recording cannot be written");
  return {};
}

std::string WireTraceWriter::append(const loop::TickRecord& tick) {
  if (file_ == nullptr) return {};
  if (header_.run.record_count == 0) first_ns_ = tick.arrival_ns;
  DeviceTraceRecord record;
  record.input = tick.in;
  record.output = tick.out;
  record.chain = chain_.extend(tick.in, tick.out);
  record.arrival_ns = static_cast<std::uint64_t>(tick.arrival_ns > first_ns_ ? tick.arrival_ns - first_ns_ : 0);
  const DeviceTraceRecordBytes bytes = encode(record);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) return because(path_, "the recording ends here");
  ++header_.run.record_count;
  return {};
}

std::string WireTraceWriter::finish(std::uint64_t blob_hash) {
  if (file_ == nullptr) return {};
  header_.run.blob_hash = blob_hash;
  bool good = std::fflush(file_) == 0;
  if (!good) {  // keep the records that arrived whole
    const off_t size = lseek(fileno(file_), 0, SEEK_END);
    const auto whole =
        size > static_cast<off_t>(device_trace_layout::kHeaderBytes) ? size - static_cast<off_t>(device_trace_layout::kHeaderBytes) : 0;
    header_.run.record_count = static_cast<std::uint64_t>(whole) / device_trace_layout::kRecordBytes;
  }
  const auto length = static_cast<off_t>(device_trace_layout::kHeaderBytes + header_.run.record_count * device_trace_layout::kRecordBytes);
  const DeviceTraceHeaderBytes bytes = encode(header_);
  const int file = fileno(file_);
  good = header_.run.record_count > 0 && ftruncate(file, length) == 0 &&
         pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) && fsync(file) == 0;
  std::string complaint = good || header_.run.record_count == 0 ? std::string() : because(path_, "the recording cannot be completed");
  std::fclose(file_);
  file_ = nullptr;
  if (good && std::rename(part().c_str(), path_.c_str()) != 0) complaint = because(path_, "the recording cannot be given its name");
  if (!good || !complaint.empty()) std::remove(part().c_str());
  return complaint;
}

std::string read_wire_trace(const std::string& path, WireTrace& trace) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) return because(path, "it cannot be read");
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
    const auto at = std::span(bytes).subspan(device_trace_layout::kHeaderBytes + i * device_trace_layout::kRecordBytes);
    const auto record = decode_device_record(at.first<device_trace_layout::kRecordBytes>());
    if (!record) return path + ": record " + std::to_string(i) + ": " + describe(record.error());
    trace.records.push_back(*record);
  }
  return {};
}

}  // namespace isotouch::io
