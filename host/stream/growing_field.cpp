#include "host/stream/growing_field.h"

#include <utility>

#include "host/field_file/make_patch.h"
#include "host/live/bucket.h"

namespace isotouch::stream {

namespace {

encoding::FieldInfo with_placement(encoding::FieldInfo info, const cloud::Placement& placement) {
  info.placement = placement;
  return info;
}

}  // namespace

GrowingField::GrowingField(const live::Space& space, double band, encoding::FieldInfo info, std::optional<Clock::duration> keep,
                           std::uint32_t enough)
    : space_(space), field_(space.grid, band, with_placement(std::move(info), space.placement)), keep_(keep), enough_(enough) {}

/// Counts a point that its bucket still wants.
bool GrowingField::has_enough(const live::Point& point, Clock::time_point at) {
  if (enough_ == 0) return false;
  Place& place = places_[live::bucket_key(point)];
  if (place.held < enough_) {
    ++place.held;
    return false;
  }
  if (keep_) {
    if (place.waiting.size() == enough_) place.waiting.erase(place.waiting.begin());
    place.waiting.push_back({at, point});
  }
  return true;
}

void GrowingField::remove_old(Clock::time_point at, live::Batch& batch) {
  while (keep_ && !old_.empty() && at - old_.begin()->first >= *keep_) {
    const std::vector<live::Point>& gone = old_.begin()->second;
    batch.removed.insert(batch.removed.end(), gone.begin(), gone.end());
    old_.erase(old_.begin());
  }
  if (enough_ == 0) return;
  for (const live::Point& gone : batch.removed) --places_[live::bucket_key(gone)].held;
}

/// Places whose points went take those that wait: a place that is seen for long stays.
void GrowingField::refill(Clock::time_point at, live::Batch& batch) {
  if (enough_ == 0) return;
  for (const live::Point& gone : batch.removed) {
    const auto found = places_.find(live::bucket_key(gone));
    if (found == places_.end()) continue;
    Place& place = found->second;
    for (; place.held < enough_ && !place.waiting.empty(); place.waiting.pop_back()) {
      const Waiting& next = place.waiting.back();
      if (at - next.at >= *keep_) {
        place.waiting.clear();
        break;
      }
      batch.added.push_back(next.point);
      old_[next.at].push_back(next.point);
      ++place.held;
    }
    if (place.held == 0) places_.erase(found);
  }
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
    } else if (has_enough(*point, at)) {
      ++counts.surplus;
    } else {
      batch.added.push_back(*point);
    }
  }
  if (keep_ && !batch.added.empty()) {
    std::vector<live::Point>& now = old_[at];
    now.insert(now.end(), batch.added.begin(), batch.added.end());
  }
  refill(at, batch);
  counts.taken = batch.added.size();
  work_ = field_.apply(batch);
  changed_ = changed_ || work_.changed > 0;
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
