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
bool GrowingField::has_enough(const live::Point& point) {
  if (enough_ == 0) return false;
  std::uint32_t& held = held_[live::bucket_key(point)];
  if (held >= enough_) return true;
  ++held;
  return false;
}

PointCounts GrowingField::take(const cloud::Model& model, Clock::time_point at) {
  PointCounts counts;
  live::Batch batch;
  while (keep_ && !old_.empty() && at - old_.front().at >= *keep_) {
    const std::vector<live::Point>& gone = old_.front().points;
    batch.removed.insert(batch.removed.end(), gone.begin(), gone.end());
    old_.pop_front();
  }
  for (const live::Point& gone : batch.removed) {
    if (enough_ > 0 && --held_[live::bucket_key(gone)] == 0) held_.erase(live::bucket_key(gone));
  }
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
    } else if (has_enough(*point)) {
      ++counts.surplus;
    } else {
      batch.added.push_back(*point);
    }
  }
  counts.taken = batch.added.size();
  work_ = field_.apply(batch);
  changed_ = changed_ || work_.changed > 0;
  if (keep_ && !batch.added.empty()) old_.push_back({at, std::move(batch.added)});
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
