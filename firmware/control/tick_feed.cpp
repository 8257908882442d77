#include "firmware/control/tick_feed.h"

#include <algorithm>
#include <string>

namespace isotouch::control {

namespace {

using protocol::Kind;
using trace_layout::kRecordBytes;

/// Beside the records a frame holds where they begin.
constexpr std::size_t kRecordRoom = protocol::kMaxBody - 32;

constexpr const char* kTooSlow =
    "the recording ended: the connection was too slow for this tick rate; use a faster connection or a lower tick rate";

}  // namespace

TickFeed::TickFeed(loop::TraceRing* ring, const TraceHeader& header, loop::Requests& requests)
    : ring_(ring), header_(header), records_(header), requests_(requests), bytes_(kRecordRoom) {
  header_.has_outputs = true;
}

void TickFeed::subscribe(ControlClient& client, std::uint32_t every) {
  client.every = every;
  client.lost = 0;
  client.ring_lost = ring_->lost();
}

void TickFeed::record(ControlClient& client, const protocol::Accepted& field) {
  header_.field_hash = field.image_hash;
  records_ = recording::RecordMaker(header_);
  const TraceHeaderBytes header = encode(header_);
  client.say(Kind::kRecording, protocol::Recording{header});
  client.records = true;
  client.every = 0;
  begun_ = false;
  generation_ = field.generation;
  requests_.ask(kRequestRestart, author_of(client.user));
}

void TickFeed::end_recording(ControlClient& client) { client.records = false; }

bool TickFeed::is_free(std::span<const ControlClient> clients) const {
  return std::none_of(clients.begin(), clients.end(), [](const ControlClient& c) { return c.records; });
}

bool TickFeed::pump(std::span<ControlClient> clients, PostureMeter& meter, WorstTicks& worst, std::int64_t now_ns) {
  if (!is_there()) return false;
  const bool wanted =
      std::any_of(clients.begin(), clients.end(), [](const ControlClient& c) { return c.is_open() && (c.every > 0 || c.records); });
  // A ring's worth at most, so that a tick quicker than this thread cannot hold it here.
  for (std::size_t taken = 0; taken <= ring_->size();) {
    std::size_t size = 0;
    while (size < kBatch && ring_->pop(batch_[size])) ++size;
    taken += size;
    const auto ticks = std::span(batch_).first(size);
    for (std::size_t i = 0; i < size && !meter.has_ended(); ++i) meter.take(batch_[i]);
    for (const loop::TickRecord& tick : ticks) worst.take(tick);
    for (ControlClient& client : clients) {
      if (!client.is_open() || client.leaving) continue;
      // This thread may come late to a ring that holds more than a client has room for; a broken connection is found when it is served.
      if (!client.has_room()) (void)client.send(now_ns);
      if (client.every > 0) give(client, ticks);
      if (client.records) give_recording(client, ticks);
    }
    if (size < kBatch) break;
  }
  return wanted;
}

void TickFeed::give(ControlClient& client, std::span<const loop::TickRecord> ticks) {
  std::uint64_t first = 0, next = 0;
  for (const loop::TickRecord& tick : ticks) {
    if (tick.number % client.every != 0) continue;
    if (used_ > 0 && (tick.number != next || used_ + kRecordBytes > bytes_.size())) (void)flush(client, first, client.every);
    if (used_ == 0) first = tick.number;
    put({tick.in, tick.out, 0, 0});
    next = tick.number + client.every;
  }
  if (used_ > 0) (void)flush(client, first, client.every);
}

/// One record more of those that go together.
void TickFeed::put(const TraceRecord& record) {
  const TraceRecordBytes bytes = encode(record);
  std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ += bytes.size();
}

void TickFeed::give_recording(ControlClient& client, std::span<const loop::TickRecord> ticks) {
  std::uint64_t first = 0;
  const auto end = [&](const char* why) {
    if (used_ > 0) (void)flush(client, first, 1);  // all before the end counts
    client.records = false;
    client.refuse(Kind::kRecord, why);
  };
  for (const loop::TickRecord& tick : ticks) {
    if (!begun_) {
      if ((tick.in.requests & kRequestRestart) == 0) continue;
      begun_ = true;
      next_ = tick.number;
    }
    if (tick.number != next_) return end(kTooSlow);
    if ((tick.in.requests & kRequestMoved) != 0)
      return end("the recording ended: the field was patched; record again when no patches come");
    if (tick.in.field_generation != generation_) return end("the recording ended: another field was loaded; record again");
    if (used_ + kRecordBytes > bytes_.size() && !flush(client, first, 1)) return end(kTooSlow);
    if (used_ == 0) first = tick.number;
    put(records_(tick));
    ++next_;
  }
  if (used_ > 0 && !flush(client, first, 1)) end(kTooSlow);
}

/// The records that are together go into a frame. returns false: they are lost, the client has not read enough
bool TickFeed::flush(ControlClient& client, std::uint64_t first, std::uint32_t every) {
  const auto records = std::span(bytes_).first(used_);
  used_ = 0;
  if (!client.has_room()) {
    client.lost += records.size() / kRecordBytes;
    return false;
  }
  client.say(Kind::kRecords, protocol::Records{first, every, static_cast<std::uint32_t>(kRecordBytes),
                                               client.lost + (ring_->lost() - client.ring_lost), records});
  return true;
}

}  // namespace isotouch::control
