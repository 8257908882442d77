#include "shared/files/trace_writer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "shared/bytes.h"
#include "shared/files/missing_folder.h"
#include "shared/files/sync_folder.h"

namespace isotouch::files {

using namespace trace_layout;

namespace {

constexpr std::size_t kTogether = 200 * kRecordBytes;  // bytes that are written at a time

std::string because(const std::string& path, const std::string& what, int error) {
  return path + ": " + what + ": " + std::strerror(error);
}

}  // namespace

TraceWriter::~TraceWriter() { discard(); }

Refusal TraceWriter::begin(const std::string& path, const TraceHeader& header, Leftover leftover) {
  if (Refusal refusal = check(path, header)) return refusal;
  const OutputPlace place = output_place(path_);
  struct stat there {};
  if (place.descriptor >= 0 ||
      (::stat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode)))  // a device would be replaced, if the user may do so
    return path_ + ": is a folder, a device or a pipe; name a file for the trace";
  if (Refusal missing = refusal_of_missing_folder(place.path)) return missing;
  target_ = place.path;
  OpenPart part = open_part(this->part(), leftover);
  if (part.refusal) return path_ + ": the trace cannot be written: " + part.refusal.sentence();
  file_ = part.file;
  return write_header();
}

Refusal TraceWriter::begin(const std::string& path, const TraceHeader& header, int file) {
  if (Refusal refusal = check(path, header)) return refusal;
  target_.clear();
  file_ = ::fcntl(file, F_DUPFD_CLOEXEC, 0);
  if (file_ < 0) return because(path_, "the trace cannot be written", errno);
  return write_header();
}

/// Forgets what was begun before.
Refusal TraceWriter::check(const std::string& path, const TraceHeader& header) {
  discard();
  path_ = path;
  header_ = header;
  header_.record_count = 0;
  chain_ = 0;
  failed_ = 0;
  const Result<TraceHeader> readable = decode_header(encode(header_), kHeaderBytes);
  if (!readable) return path_ + ": the trace cannot be written: " + describe(readable.error());
  return {};
}

Refusal TraceWriter::write_header() {
  const TraceHeaderBytes bytes = unfinished();
  waiting_.assign(bytes.begin(), bytes.end());
  if (flush()) return {};
  const int why = failed_;
  discard();
  return because(path_, "the trace cannot be written", why);
}

TraceHeaderBytes TraceWriter::unfinished() const {
  TraceHeader header = header_;
  header.record_count = kUnfinished;
  return encode(header);
}

void TraceWriter::set_field_hash(std::uint64_t hash) {
  if (hash == header_.field_hash) return;
  header_.field_hash = hash;
  const TraceHeaderBytes bytes = unfinished();
  if (is_open()) (void)!::pwrite(file_, bytes.data(), bytes.size(), 0);  // `finish` says what goes wrong
}

Refusal TraceWriter::append(const TraceRecord& record) {
  if (!is_open()) return {};
  const TraceRecordBytes bytes = encode(record);
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  chain_ = record.chain;
  ++header_.record_count;
  if (waiting_.size() < kTogether || flush()) return {};
  return because(path_, "the trace ends here", failed_);
}

/// returns   false: the file takes no more, now or since before
bool TraceWriter::flush() {
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

/// Where a file took no more, only the file knows how much it holds: the last record may be cut.
///
/// returns   false: it can be neither measured nor cut
bool TraceWriter::cut_to_whole_records() {
  const off_t size = ::lseek(file_, 0, SEEK_END);
  const auto bytes = static_cast<std::uint64_t>(size < 0 ? 0 : size);
  header_.record_count = bytes < kHeaderBytes ? 0 : (bytes - kHeaderBytes) / kRecordBytes;
  chain_ = 0;
  if (header_.record_count == 0) return true;
  const std::uint64_t end = kHeaderBytes + header_.record_count * kRecordBytes;
  std::array<std::uint8_t, 8> chain{};
  const bool read = ::pread(file_, chain.data(), chain.size(), static_cast<off_t>(end - kRecordBytes + kChainAt)) == 8;
  chain_ = load_le<std::uint64_t>(chain.data());
  return read && ::ftruncate(file_, static_cast<off_t>(end)) == 0;
}

Refusal TraceWriter::finish(Keep keep) {
  if (!is_open()) return {};
  const bool took_all = flush();
  if (!took_all && keep == Keep::kAllOrNothing) {
    const int why = failed_;
    discard();
    return because(path_, "the trace cannot be written to its end", why) + "; make room there";
  }
  const bool whole = took_all || cut_to_whole_records();
  const bool wanted = records() > 0 || keep == Keep::kAllOrNothing;
  const TraceHeaderBytes bytes = encode(header_);
  const bool kept =
      whole && wanted && ::pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) &&
      (target_.empty() || (::fsync(file_) == 0 && std::rename(part().c_str(), target_.c_str()) == 0 && sync_folder_of(target_)));
  const int why = errno;
  if (!kept && !target_.empty()) std::remove(part().c_str());  // before the lock ends with the file
  ::close(std::exchange(file_, -1));
  if (!kept) {
    header_.record_count = 0;
    chain_ = 0;
  }
  if (failed_ != 0 && kept) {
    return because(path_, "the trace ends after " + std::to_string(records()) + " ticks", failed_) + "; make room there";
  }
  if (failed_ != 0) return because(path_, "nothing was recorded", failed_) + "; make room there";
  return kept || !wanted ? std::string() : because(path_, "the trace cannot be completed", why);
}

void TraceWriter::discard() {
  if (!is_open()) return;
  waiting_.clear();
  if (!target_.empty()) std::remove(part().c_str());  // before the lock ends with the file
  ::close(std::exchange(file_, -1));
}

}  // namespace isotouch::files
