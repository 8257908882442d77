/// Between a source of frames and whoever works on them: room for one frame. A newer one takes the place of one that still waits, unless it is empty,
/// so what is worked on is never older than one frame's work, and memory does not grow.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

#include "host/cloud/model.h"

namespace isotouch::stream {

using Clock = std::chrono::steady_clock;

struct Frame {
  std::uint64_t number = 0;             ///< from 1
  std::function<cloud::Model()> read;   ///< its points; called once, by whoever works on it
  std::optional<Clock::time_point> at;  ///< when it arrived; a frame that may wait arrives when it is taken
  bool is_empty = false;                ///< nothing was seen, as is known without reading it
};

class Inbox {
 public:
  // The source's side, a thread.

  /// A frame of a source that does not wait: one that nobody took until now is left out, or this one, where it is empty. Its time is now.
  ///
  /// returns   false: nobody takes any more
  bool offer(Frame frame);
  /// A frame of a source that can wait until the one before was taken.
  bool hand_over(Frame frame);
  /// Does no frame wait? Then the next one that is offered takes nobody's place.
  bool has_room() const;
  /// So many frames were due and could not even be made: they count as left out.
  void miss(std::uint64_t frames);
  /// A tick of a hand arrived. That many before it did not, and nobody knows what they touched.
  void hear(std::uint64_t lost = 0);
  /// That many of a hand arrived, and what they touched was left out.
  void lose(std::uint64_t ticks);
  /// False at once when nobody takes any more.
  bool wait_until(Clock::time_point time);
  bool is_closed() const;
  /// There will be no more frames; because of an error, where there is one.
  void finish(std::exception_ptr error = {});

  // The worker's side.

  /// The frame that waits, or the next one.
  ///
  /// returns   nothing: none came in that time, or there are no more
  /// fails     with the source's error, once all frames before it were taken
  std::optional<Frame> take(std::chrono::milliseconds patience);
  bool is_finished() const;
  /// How many frames there were, and how many of them were left out.
  std::uint64_t offered() const;
  std::uint64_t thinned() const;
  std::uint64_t heard() const;  ///< ticks
  std::uint64_t lost() const;
  /// No more are taken; one that still waits is left out.
  void close();

 private:
  mutable std::mutex lock_;
  std::condition_variable changed_;
  std::optional<Frame> waiting_;
  std::exception_ptr error_;
  bool finished_ = false, closed_ = false;
  std::uint64_t offered_ = 0, thinned_ = 0, heard_ = 0, lost_ = 0;
};

}  // namespace isotouch::stream
