/// A live field with what a stream needs around it: points come in frames and may go again after a while, and each state leads to the next by a patch.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "host/cloud/model.h"
#include "host/field_file/open_field.h"
#include "host/live/live_field.h"
#include "host/live/space.h"
#include "host/stream/inbox.h"

namespace isotouch::stream {

/// What became of points.
struct PointCounts {
  std::size_t taken = 0;
  std::size_t outside = 0;  ///< of the box
  std::size_t useless = 0;  ///< without a normal
  std::size_t surplus = 0;  ///< left out because their places had enough. Points that still wait are counted once they stop
  std::size_t expired = 0;  ///< taken, and removed again

  PointCounts& operator+=(const PointCounts& more) {
    taken += more.taken;
    outside += more.outside;
    useless += more.useless;
    surplus += more.surplus;
    expired += more.expired;
    return *this;
  }
};

class GrowingField {
 public:
  static constexpr std::size_t kTurns = 8;
  static constexpr std::size_t kMaxWaiting =
      64;  ///< points of a bucket that wait for it to double; those that wait to take the place of others come on top

  /// info      its placement is that of the space
  /// keep      how long a point counts; not given: for good
  /// enough    that many points of a bucket count; 0: all. A bucket that has some takes further ones when its block has its turn, every `kTurns`
  ///           frames, if they double or fill it by then or are kMaxWaiting; or when some of its own go. Until then they wait, and so do the first ones of
  ///           a bucket next to one that has some. Those beyond enough are left
  ///           out. With `keep`, the newest of them wait, too, and all only as long as they are no older than `keep` themselves
  /// fails     as LiveField
  GrowingField(const live::Space& space, double band, encoding::FieldInfo info, std::optional<Clock::duration> keep,
               std::uint32_t enough = 0);

  /// Takes the points of a frame in. Those of a frame that is at least `keep` older than this one go.
  ///
  /// model     input coordinates; with a normal for each position, or none of its points is taken
  /// at        not earlier than that of the frame before
  PointCounts take(const cloud::Model& model, Clock::time_point at);
  /// Takes in the points that wait although their places have not enough, of the blocks of one turn: for a time in which no frame comes.
  ///
  /// at        as for `take`
  PointCounts take_waiting(Clock::time_point at);
  /// Is there a turn with such points?
  bool has_waiting() const;
  /// Takes in those of all turns, and leaves out what waits besides: there will be no more frames.
  PointCounts finish(Clock::time_point at);

  /// Do bricks differ from those of the last state that was kept?
  bool has_changed() const { return changed_; }
  const live::Verdict& verdict() const { return field_.verdict(); }
  const live::Work& work() const { return work_; }

  /// Keeps this state: the next patch leads on from it.
  const field_file::OpenField& keep_whole();
  /// Keeps this state, and returns the patch (SPEC.md, section 7) from the last one that was kept.
  ///
  /// returns   nothing: they are equal
  std::vector<std::uint8_t> keep_patch();
  /// The state that was kept last.
  const field_file::OpenField& kept() const { return *kept_; }
  std::uint64_t kept_hash() const { return kept_hash_; }

 private:
  struct Waiting {
    Clock::time_point at;
    live::Point point;
  };
  /// A bucket, where `enough_` counts its points.
  struct Place {
    std::uint32_t held = 0;        ///< points that count
    bool is_touched = false;       ///< by the batch
    bool is_urgent = false;        ///< takes what waits with the batch
    std::vector<Waiting> waiting;  ///< the newest last
  };

  enum class Wanted { kAll, kDoubled };

  void touch(std::uint64_t key, Place& place);
  std::size_t wait(const live::Point& point, Clock::time_point at);
  void remove_old(Clock::time_point at, live::Batch& batch);
  std::size_t fill(Place& place, Clock::time_point at, live::Batch& batch);
  static std::size_t turn_of(std::uint64_t key);
  bool is_beside(std::uint64_t key) const;
  std::size_t settle(Clock::time_point at, live::Batch& batch);
  std::size_t fill_turn(std::size_t turn, Wanted wanted, Clock::time_point at, live::Batch& batch);
  void apply(const live::Batch& batch);

  live::Space space_;
  live::LiveField field_;
  std::optional<Clock::duration> keep_;
  std::uint32_t enough_;
  std::unordered_map<std::uint64_t, Place> places_;  ///< by bucket
  std::vector<std::uint64_t> touched_;               ///< of them, by the batch
  std::uint64_t frames_ = 0;                         ///< taken
  std::array<std::unordered_set<std::uint64_t>, kTurns>
      unsettled_;  ///< by turn, all where points wait although enough do not count yet, and others
  std::map<Clock::time_point, std::vector<live::Point>> old_;  ///< points that count, where they go again, by when they came
  live::Work work_;
  bool changed_ = false;
  std::optional<field_file::OpenField> kept_;
  std::uint64_t kept_hash_ = 0;
};

}  // namespace isotouch::stream
