#include "firmware/recording/last_ticks.h"

#include <fcntl.h>
#include <sys/mman.h>
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

LastTicks::~LastTicks() { unmap(); }

Refusal LastTicks::begin(const std::string& path, const TraceHeader& header, std::size_t slots) {
  unmap();
  ::unlink(path.c_str());  // a new file is nobody else's, and no link
  const ScopedFile file{::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600)};
  const int why = file.number < 0 ? errno : ::posix_fallocate(file.number, 0, static_cast<off_t>(file_bytes(slots)));
  void* mapped = why != 0 ? MAP_FAILED : ::mmap(nullptr, file_bytes(slots), PROT_READ | PROT_WRITE, MAP_SHARED, file.number, 0);
  if (mapped == MAP_FAILED) {
    if (file.number >= 0) ::unlink(path.c_str());
    return path + ": the last ticks before a kill cannot be kept: " + std::strerror(why != 0 ? why : errno);
  }
  path_ = path;
  bytes_ = {static_cast<std::uint8_t*>(mapped), file_bytes(slots)};
  slots_ = slots;
  next_ = 0;
  const TraceHeaderBytes bytes = encode(header);
  std::copy(bytes.begin(), bytes.end(), bytes_.begin());
  return {};
}

void LastTicks::put(const LastTick& last) {
  if (bytes_.empty()) return;
  std::uint8_t* slot = bytes_.data() + kHeaderBytes + next_ * kSlotBytes;
  next_ = (next_ + 1) % slots_;
  const TraceRecordBytes record =
      encode(TraceRecord{last.tick.in, last.tick.out, last.tick.number, static_cast<std::uint64_t>(last.tick.arrival_ns)});
  std::copy(record.begin(), record.end(), slot);
  store_le(slot + kHashAt, last.field_hash);
  store_le(slot + kChecksumAt, crc32(slot, kChecksumAt));
}

void LastTicks::end() {
  if (bytes_.empty()) return;
  unmap();
  ::unlink(path_.c_str());
}

void LastTicks::unmap() {
  if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
  bytes_ = {};
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
