#include "host/stream/growing_field.h"

#include <algorithm>
#include <utility>

#include "host/field_file/make_patch.h"
#include "host/live/bucket.h"

namespace isotouch::stream {

namespace {

constexpr unsigned kBlockBits = 4;  // a block is so many doublings of a bucket wide: 32 voxels

encoding::FieldInfo with_placement(encoding::FieldInfo info, const cloud::Placement& placement) {
  info.placement = placement;
  return info;
}

}  // namespace

GrowingField::GrowingField(const live::Space& space, double band, encoding::FieldInfo info, std::optional<Clock::duration> keep,
                           std::uint32_t enough)
    : space_(space), field_(space.grid, band, with_placement(std::move(info), space.placement)), keep_(keep), enough_(enough) {}

/// When the block of a bucket has its turn; those side by side have different ones.
std::size_t GrowingField::turn_of(std::uint64_t key) {
  const Eigen::Vector3i bucket = live::bucket_place(key);
  return static_cast<std::size_t>((bucket.x() >> kBlockBits) + (bucket.y() >> kBlockBits) + (bucket.z() >> kBlockBits)) % kTurns;
}

/// Notes that the batch may change a place.
void GrowingField::touch(std::uint64_t key, Place& place) {
  if (!place.is_touched) touched_.push_back(key);
  place.is_touched = true;
}

/// Lets a point wait for its place.
///
/// returns   how many points are left out for that: this one or an older one, or none
std::size_t GrowingField::wait(const live::Point& point, Clock::time_point at) {
  const std::uint64_t key = live::bucket_key(point);
  Place& place = places_[key];
  if (!keep_ && place.held + place.waiting.size() >= enough_) return 1;
  const bool is_full = place.waiting.size() == enough_;
  if (is_full) place.waiting.erase(place.waiting.begin());
  place.waiting.push_back({at, point});
  touch(key, place);
  return is_full ? 1 : 0;
}

void GrowingField::remove_old(Clock::time_point at, live::Batch& batch) {
  while (keep_ && !old_.empty() && at - old_.begin()->first >= *keep_) {
    const std::vector<live::Point>& gone = old_.begin()->second;
    batch.removed.insert(batch.removed.end(), gone.begin(), gone.end());
    old_.erase(old_.begin());
  }
  if (enough_ == 0) return;
  for (const live::Point& gone : batch.removed) {
    const std::uint64_t key = live::bucket_key(gone);
    Place& place = places_[key];
    --place.held;
    place.is_urgent = true;
    touch(key, place);
  }
}

/// Takes the newest of what waits. Nothing waits afterwards unless the place has enough.
///
/// returns   how many points are left out, because they have become too old
std::size_t GrowingField::fill(Place& place, Clock::time_point at, live::Batch& batch) {
  for (; place.held < enough_ && !place.waiting.empty(); place.waiting.pop_back()) {
    const Waiting& next = place.waiting.back();
    if (keep_ && at - next.at >= *keep_) return std::exchange(place.waiting, {}).size();
    batch.added.push_back(next.point);
    if (keep_) old_[next.at].push_back(next.point);
    ++place.held;
  }
  return 0;
}

/// Does a place next to this one have points that count and look the same way? Then there is a surface already.
bool GrowingField::is_beside(std::uint64_t key) const {
  constexpr int kAround = 27;
  for (int n = 0; n < kAround; ++n) {
    const auto found = places_.find(live::bucket_beside(key, {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1}));
    if (found != places_.end() && found->second.held > 0) return true;
  }
  return false;
}

/// Fills the places where no surface was, those that are computed anyway because some points went, and of those whose block has its turn the ones whose
/// points have doubled: a place that followed each point would be computed anew for an ever smaller part of its mean, and its neighbours with it. As
/// many as kMaxWaiting are taken all the same, so that memory does not grow with the points that were seen.
///
/// returns   how many points are left out
std::size_t GrowingField::settle(Clock::time_point at, live::Batch& batch) {
  std::size_t left_out = 0;
  for (const std::uint64_t key : touched_) {
    Place& place = places_.find(key)->second;
    place.is_urgent = place.is_urgent || (place.held == 0 && !is_beside(key));
  }
  for (const std::uint64_t key : touched_) {
    const auto found = places_.find(key);
    Place& place = found->second;
    if (place.is_urgent) left_out += fill(place, at, batch);
    place.is_touched = place.is_urgent = false;
    if (place.held < enough_ && !place.waiting.empty()) unsettled_[turn_of(key)].insert(key);
    if (place.held == 0 && place.waiting.empty()) places_.erase(found);
  }
  touched_.clear();
  return left_out + fill_turn(frames_++ % kTurns, Wanted::kDoubled, at, batch);
}

/// Fills of the blocks of one turn the places that have not enough: all of them, or those that `settle` names.
///
/// returns   as `settle`
std::size_t GrowingField::fill_turn(std::size_t turn, Wanted wanted, Clock::time_point at, live::Batch& batch) {
  std::size_t left_out = 0;
  std::erase_if(unsettled_[turn], [&](std::uint64_t key) {
    const auto found = places_.find(key);
    if (found == places_.end()) return true;
    Place& place = found->second;
    const bool is_wanted =
        wanted == Wanted::kAll || place.waiting.size() >= std::min<std::size_t>({place.held, kMaxWaiting, enough_ - place.held});
    if (is_wanted) left_out += fill(place, at, batch);
    const bool is_settled = place.held == enough_ || place.waiting.empty();
    if (place.held == 0 && is_settled) places_.erase(found);
    return is_settled;
  });
  return left_out;
}

void GrowingField::apply(const live::Batch& batch) {
  work_ = field_.apply(batch);
  changed_ = changed_ || work_.changed > 0;
}

PointCounts GrowingField::take(const cloud::Model& model, Clock::time_point at) {
  PointCounts counts;
  live::Batch batch;
  remove_old(at, batch);
  counts.expired = batch.removed.size();
  batch.added.reserve(model.positions.size());
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    if (!space_.box.contains(model.positions[i])) {
      ++counts.outside;
      continue;
    }
    const auto point = i < model.normals.size()
                           ? live::point_in(space_.grid, space_.placement.to_workspace(model.positions[i]), model.normals[i])
                           : std::nullopt;
    if (!point) {
      ++counts.useless;
    } else if (enough_ == 0) {
      batch.added.push_back(*point);
    } else {
      counts.surplus += wait(*point, at);
    }
  }
  if (enough_ > 0) {
    counts.surplus += settle(at, batch);
  } else if (keep_ && !batch.added.empty()) {
    std::vector<live::Point>& now = old_[at];
    now.insert(now.end(), batch.added.begin(), batch.added.end());
  }
  counts.taken = batch.added.size();
  apply(batch);
  return counts;
}

bool GrowingField::has_waiting() const {
  return std::any_of(unsettled_.begin(), unsettled_.end(), [](const auto& keys) { return !keys.empty(); });
}

PointCounts GrowingField::take_waiting(Clock::time_point at) {
  PointCounts counts;
  live::Batch batch;
  for (std::size_t turn = 0; turn < kTurns && batch.added.empty(); ++turn) counts.surplus += fill_turn(turn, Wanted::kAll, at, batch);
  counts.taken = batch.added.size();
  if (counts.taken > 0) apply(batch);
  return counts;
}

PointCounts GrowingField::finish(Clock::time_point at) {
  PointCounts counts;
  live::Batch batch;
  for (std::size_t turn = 0; turn < kTurns; ++turn) counts.surplus += fill_turn(turn, Wanted::kAll, at, batch);
  for (auto& [key, place] : places_) counts.surplus += std::exchange(place.waiting, {}).size();
  counts.taken = batch.added.size();
  if (counts.taken > 0) apply(batch);
  return counts;
}

const field_file::OpenField& GrowingField::keep_whole() {
  kept_.emplace(field_file::open_field(field_.image(), "the field"));
  kept_hash_ = kept_->view.hash();
  changed_ = false;
  return *kept_;
}

std::vector<std::uint8_t> GrowingField::keep_patch() {
  field_file::OpenField after = field_file::open_field(field_.image(), "the field");
  const std::uint64_t hash = after.view.hash();
  changed_ = false;
  if (hash == kept_hash_) return {};
  std::vector<std::uint8_t> patch =
      field_file::write_patch(kept_hash_, hash, after.view, field_file::changed_cells(kept_->view, after.view));
  kept_ = std::move(after);
  kept_hash_ = hash;
  return patch;
}

}  // namespace isotouch::stream
