/// What waits for one viewer. It is bounded whatever the viewer does: of ticks the newest few batches, of everything else the newest of each kind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace isotouch::server {

/// What the page is sent without asking.
enum class Topic : std::uint8_t {
  kHello,   ///< what there is to see: once, when a viewer comes
  kScene,   ///< the object is another one
  kLink,    ///< the controller came or went
  kState,   ///< what it does with the hand, in words
  kStatus,  ///< its measures and settings
  kBuild,   ///< how far a build is, or how it ended
  kTicks,
};
inline constexpr std::size_t kTopics = 7;

struct Message {
  Topic topic = Topic::kTicks;
  bool binary = false;
  std::string bytes;
};
using Shared = std::shared_ptr<const Message>;  ///< one copy for all viewers

class Outbox {
 public:
  static constexpr std::size_t kMaxBatches = 8;  ///< of ticks that wait
  static constexpr std::size_t kMaxUnseen = 2;   ///< batches that were sent and that the viewer has not shown yet

  /// Of ticks the oldest batch is dropped when too many wait; anything else replaces what waits of its topic. Where a controller came or went, what waits
  /// of the one before is dropped.
  void put(const Shared& message);
  /// The next to be sent; nothing while the viewer has yet to show what it got.
  std::optional<Shared> take();
  /// The viewer has shown one more batch.
  void seen() {
    if (unseen_ > 0) --unseen_;
  }
  /// Batches of ticks that this viewer was too slow for.
  std::uint64_t dropped() const { return dropped_; }

 private:
  void forget_controller();

  std::array<Shared, kTopics> newest_;
  std::deque<Shared> batches_;
  std::size_t unseen_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace isotouch::server
