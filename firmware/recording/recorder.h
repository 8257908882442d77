/// Takes every tick off the ring: into a recording when one is wanted, into the memory of the last seconds always, and on to whoever else wants
/// ticks. When the supervisor enters fault, it is saved to a file with what was before and shortly after.
///
/// A recording begins with a tick that forgot everything before it, so that it replays; one that the ring lost a tick of, or that another field came
/// into, ends there. A patch of its field goes into a file beside it. What is saved at a fault holds the fault whatever came after it, and neither
/// before nor after it a patch. It begins in the middle: it shows what happened, its first ticks
/// do not replay. The same seconds are in a file that survives a kill, `last_ticks.h`; the next run saves them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "firmware/loop/latest.h"
#include "firmware/loop/requests.h"
#include "firmware/loop/tick_record.h"
#include "firmware/recording/last_ticks.h"
#include "firmware/recording/numbered_traces.h"
#include "firmware/recording/patch_writer.h"
#include "firmware/recording/tick_writer.h"
#include "shared/files/refusal.h"
#include "shared/files/state_text.h"

namespace isotouch::recording {

struct RecorderSettings {
  TraceHeader header;             ///< device, settings and period of every recording
  std::string state;              ///< folder for what is saved at a fault; empty: nothing is saved
  std::size_t remembered = 5000;  ///< ticks before a fault
  std::size_t after_fault = 500;  ///< ticks after it, saved too
  std::size_t most_saved = 16;    ///< in one run of the program
  std::size_t most_kept = 64;     ///< of faults, and of crashes, over all runs: the newest
};

class Recorder {
 public:
  /// ring          its reader is this recorder
  /// passed_on     gets every tick, too; nullptr: nobody else does
  /// hash_of       the field's hash of a field's generation, 0 = not known (yet)
  /// tell          gets one sentence whenever a recording ends or fails, or something was saved
  Recorder(RecorderSettings settings, loop::TraceRing& ring, loop::TraceRing* passed_on, loop::Requests& requests,
           std::function<std::uint64_t(std::uint32_t)> hash_of, std::function<void(const std::string&)> tell);
  /// Completes what is being written.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Begins a recording with the next tick that forgets; before the first tick, with that. Any thread.
  ///
  /// returns   why it does not begin
  Refusal start(const std::string& path);
  /// Ends the recording. Any thread.
  ///
  /// newest    number of the newest tick that there was; the ring may have lost it
  void stop(std::uint64_t newest);
  /// Leaves nothing of a recording that another run begins anew. Any thread.
  void discard();

  /// A patch is going to be handed to the tick. In a recording it is kept until the tick that takes it over comes, or too much was told since; without
  /// one, until the next is told. Any thread.
  void tell_patch(std::uint64_t hash_after, std::span<const std::uint8_t> patch);

  /// The recorder's thread, every 50 ms or so: takes what the ring holds.
  void drain();

  /// Of all recordings so far the worst. Any thread.
  enum class Outcome : std::uint8_t {
    kAsAsked,
    kEndedEarly,  ///< what came until then is whole under its name
    kLost,        ///< it is not whole under its name
  };
  Outcome outcome() const { return outcome_; }

  /// Of the newest tick taken, as people are told; one thread. Behind the tick by as much as the disk is slow.
  files::Condition condition() { return condition_.get(); }

  /// A tick, as people are told.
  static files::Condition condition_of(const loop::TickRecord& tick) {
    return {tick.out.state, tick.faults, tick.out.status, tick.in.field_generation != 0};
  }

 private:
  void take(const loop::TickRecord& tick);
  void record(const loop::TickRecord& tick);
  Refusal record_patch(std::uint32_t moved_to);
  void keep_patches(bool wanted);
  void remember(const loop::TickRecord& tick);
  void end(const std::string& why, Outcome outcome = Outcome::kEndedEarly);
  void save();
  void keep_last_ticks();
  NumberedTraces saved(const char* kind) const;

  RecorderSettings settings_;
  loop::TraceRing& ring_;
  loop::TraceRing* passed_on_;
  loop::Requests& requests_;
  std::function<std::uint64_t(std::uint32_t)> hash_of_;
  std::function<void(const std::string&)> tell_;

  std::mutex mutex_;  ///< between whoever starts and stops, and the recorder's thread; the tick knows nothing of it
  TickWriter writer_;
  bool begun_ = false;            ///< the recording's first tick has come
  std::uint64_t next_ = 0;        ///< tick that the recording goes on with
  std::uint32_t generation_ = 0;  ///< of the recording's field
  std::uint64_t hash_ = 0;
  PatchWriter patch_writer_;

  struct Patch {
    std::uint64_t hash_after = 0;
    std::vector<std::uint8_t> bytes;
  };
  static constexpr std::size_t kPatchesKept = 64, kPatchBytesKept = 32U << 20U;
  std::mutex patches_mutex_;
  std::deque<Patch> patches_;  ///< the newest last
  bool keeps_patches_ = false;

  LastTicks last_ticks_;                  ///< the same for a kill
  LastTick newest_;                       ///< its field, so that its hash is asked for once
  std::vector<loop::TickRecord> memory_;  ///< a circle
  std::size_t end_ = 0, remembered_ = 0;
  std::size_t save_in_ = 0;                       ///< ticks; 0 = no fault is to be saved
  std::uint64_t faulted_ = 0, faulted_hash_ = 0;  ///< tick of the fault that is to be saved, and the field that it was felt on
  std::size_t saved_ = 0;
  std::atomic<Outcome> outcome_{Outcome::kAsAsked};
  std::uint16_t state_ = 0;  ///< of the newest tick taken
  loop::Latest<files::Condition> condition_;
};

}  // namespace isotouch::recording
