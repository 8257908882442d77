#include "firmware/recording/last_ticks.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/files/scoped_file.h"

namespace isotouch::recording {

namespace {

using trace_layout::kHeaderBytes, trace_layout::kRecordBytes;

// A slot: the record, whose chain is the number of the tick, the hash of the field, and a checksum of both. One of zeros is none.
constexpr std::size_t kHashAt = kRecordBytes, kChecksumAt = kHashAt + 8, kSlotBytes = kChecksumAt + 8;

constexpr std::size_t file_bytes(std::size_t slots) { return kHeaderBytes + slots * kSlotBytes; }

/// returns   number 0: there is no whole tick
LastTick read_slot(const std::uint8_t* slot) {
  const Result<TraceRecord> record = decode_record(std::span<const std::uint8_t, kRecordBytes>(slot, kRecordBytes));
  if (!record || load_le<std::uint32_t>(slot + kChecksumAt) != crc32(slot, kChecksumAt)) return {};
  LastTick last;
  last.tick.number = record->chain;
  last.tick.arrival_ns = static_cast<std::int64_t>(record->arrival_ns);
  last.tick.in = record->input;
  last.tick.out = record->output;
  last.field_hash = load_le<std::uint64_t>(slot + kHashAt);
  return last;
}

}  // namespace

Refusal LastTicks::begin(const std::string& path, const TraceHeader& header, std::size_t slots) {
  ::unlink(path.c_str());  // a new file is nobody else's, and no link
  file_.emplace(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
  const bool is_made = file_->number >= 0;
  int why = is_made ? ::posix_fallocate(file_->number, 0, static_cast<off_t>(file_bytes(slots))) : errno;
  const TraceHeaderBytes bytes = encode(header);
  if (why == 0 && ::pwrite(file_->number, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) why = errno;
  if (why != 0) {
    if (is_made) ::unlink(path.c_str());
    file_.reset();
    return path + ": the last ticks before a kill cannot be kept: " + std::strerror(why);
  }
  path_ = path;
  slots_ = slots;
  next_ = 0;
  return {};
}

void LastTicks::put(const LastTick& last) {
  if (!file_) return;
  const std::size_t at = kHeaderBytes + next_ * kSlotBytes;
  next_ = (next_ + 1) % slots_;
  const TraceRecordBytes record =
      encode(TraceRecord{last.tick.in, last.tick.out, last.tick.number, static_cast<std::uint64_t>(last.tick.arrival_ns)});
  std::array<std::uint8_t, kSlotBytes> slot{};
  std::copy(record.begin(), record.end(), slot.begin());
  store_le(&slot[kHashAt], last.field_hash);
  store_le(&slot[kChecksumAt], crc32(slot.data(), kChecksumAt));
  [[maybe_unused]] const auto written = ::pwrite(file_->number, slot.data(), slot.size(), static_cast<off_t>(at));
}

void LastTicks::end() {
  if (!file_) return;
  file_.reset();
  ::unlink(path_.c_str());
}

std::vector<LastTick> LastTicks::read(const std::string& path, TraceHeader& header) {
  const ScopedFile file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)};
  TraceHeaderBytes first{};
  if (file.number < 0 || ::read(file.number, first.data(), first.size()) != static_cast<ssize_t>(first.size())) return {};
  const Result<TraceHeader> described = decode_header(first);
  if (!described) return {};
  std::vector<LastTick> ticks;
  for (std::array<std::uint8_t, kSlotBytes> slot{}; ::read(file.number, slot.data(), slot.size()) == static_cast<ssize_t>(slot.size());) {
    const LastTick last = read_slot(slot.data());
    if (last.tick.number != 0) ticks.push_back(last);
  }
  std::sort(ticks.begin(), ticks.end(), [](const LastTick& a, const LastTick& b) { return a.tick.number < b.tick.number; });
  const auto gap = std::adjacent_find(ticks.rbegin(), ticks.rend(), [](const LastTick& a, const LastTick& b) {
    return a.tick.number != b.tick.number + 1 || a.tick.in.field_generation != b.tick.in.field_generation;
  });
  if (gap != ticks.rend()) ticks.erase(ticks.begin(), (gap + 1).base());
  if (!ticks.empty()) header = *described;
  return ticks;
}

}  // namespace isotouch::recording
