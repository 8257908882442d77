/// From the ring of ticks to the clients that watch or record. Belongs to the control server's thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firmware/control/control_client.h"
#include "firmware/control/posture_meter.h"
#include "firmware/control/worst_ticks.h"
#include "firmware/loop/requests.h"
#include "firmware/loop/tick_record.h"
#include "firmware/recording/tick_writer.h"
#include "shared/trace.h"

namespace isotouch::control {

class TickFeed {
 public:
  /// ring      nullptr: nothing can be watched
  /// header    device, settings and period of every recording
  TickFeed(loop::TraceRing* ring, const TraceHeader& header, loop::Requests& requests);

  bool is_there() const { return ring_ != nullptr; }

  /// Begins or changes what the client watches; what is in the ring already is nobody's.
  ///
  /// every     a record every so many ticks; 0 = none any more
  void subscribe(ControlClient& client, std::uint32_t every);

  /// Begins the one recording: asks the tick to forget what was before, and tells the client the header. The first record is the tick that forgot.
  ///
  /// field     what the tick feels
  void record(ControlClient& client, const protocol::Accepted& field);
  void end_recording(ControlClient& client);
  /// Nobody has it: another client may.
  bool is_free(std::span<const ControlClient> clients) const;

  /// Gives what is in the ring to everybody who wants it.
  ///
  /// meter     takes every tick, too, while it measures
  /// worst     takes every tick
  /// returns   true when anybody watches: call again soon
  bool pump(std::span<ControlClient> clients, PostureMeter& meter, WorstTicks& worst, std::int64_t now_ns);

 private:
  static constexpr std::size_t kBatch = 64;

  void give(ControlClient& client, std::span<const loop::TickRecord> ticks);
  void put(const TraceRecord& record);
  void give_recording(ControlClient& client, std::span<const loop::TickRecord> ticks);
  bool flush(ControlClient& client, std::uint64_t first, std::uint32_t every);

  loop::TraceRing* ring_;
  TraceHeader header_;
  recording::RecordMaker records_;  ///< of the recording
  loop::Requests& requests_;
  std::array<loop::TickRecord, kBatch> batch_;
  std::vector<std::uint8_t> bytes_;  ///< of the records that go into one frame
  std::size_t used_ = 0;
  bool begun_ = false;            ///< the recording's first tick has come
  std::uint64_t next_ = 0;        ///< tick that the recording goes on with
  std::uint32_t generation_ = 0;  ///< of the field that the recording's header names
};

}  // namespace isotouch::control
