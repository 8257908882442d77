/// The last seconds of ticks in a file: what a controller that is killed cannot save itself, the next one finds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/loop/tick_record.h"
#include "shared/files/refusal.h"
#include "shared/files/scoped_file.h"
#include "shared/trace.h"

namespace isotouch::recording {

/// A tick, and the field that it felt; 0 = none, or not known.
struct LastTick {
  loop::TickRecord tick;
  std::uint64_t field_hash = 0;
};

/// A circle of slots behind the header of a trace. Each slot has a checksum of its own, so a tick that was being written at the kill counts as none. The
/// file survives the end of the process in any way; a power cut may take the last half minute of it. Not for the tick; one thread at a time.
class LastTicks {
 public:
  /// Makes the file anew, with all its room taken on the disk: most file systems then find room for every later write. One that copies what
  /// it writes (btrfs, ZFS) may not; a tick that it does not take is left out, and nothing else is lost. A mapped file would end the program there.
  ///
  /// header    of the ticks that will come
  /// slots     ticks that it holds, at least 1
  /// returns   why nothing is kept
  Refusal begin(const std::string& path, const TraceHeader& header, std::size_t slots);

  /// Where it has not begun, nothing happens.
  ///
  /// last      its tick's number is at least 1
  void put(const LastTick& last);

  /// Takes the file away: the run ended as it should.
  void end();

  /// What a run that was killed left: the newest ticks that follow each other on one field, oldest first.
  ///
  /// header    changed only when there are any
  /// returns   empty: there is no such file, or no whole tick in it
  static std::vector<LastTick> read(const std::string& path, TraceHeader& header);

 private:
  std::string path_;
  std::optional<ScopedFile> file_;  ///< while it is kept
  std::size_t slots_ = 0, next_ = 0;
};

}  // namespace isotouch::recording
