#include "firmware/loop/field_slots.h"

namespace isotouch::loop {

namespace {
constexpr std::size_t kLine = 64;
std::size_t whole_lines(std::size_t bytes) { return (bytes + kLine - 1) / kLine * kLine; }

/// The blocks of one part of an image begin here, and end where the next one's begin.
std::size_t border(std::size_t image_bytes, std::size_t part) {
  return static_cast<std::size_t>(std::uint64_t{BlockSums::blocks_of(image_bytes)} * part / FieldSlots::kParts);
}

}  // namespace

FieldSlots::FieldSlots(std::size_t bytes)
    : capacity_(bytes), memory_((2 * whole_lines(bytes) + kLine) / sizeof(std::uint64_t)), sums_{BlockSums(bytes), BlockSums(bytes)} {
  auto* at = reinterpret_cast<std::uint8_t*>(memory_.data());
  at += (kLine - reinterpret_cast<std::uintptr_t>(at) % kLine) % kLine;
  places_ = {at, at + whole_lines(bytes)};
}

bool FieldSlots::free() const {
  const std::uint32_t published = published_.load(std::memory_order_relaxed);
  return published == acknowledged_.load(std::memory_order_acquire) &&
         (!guarded_ || published == guard_acknowledged_.load(std::memory_order_acquire));
}

std::span<std::uint8_t> FieldSlots::begin(std::size_t bytes) {
  abandon();
  if (bytes == 0 || bytes > capacity_ || !free()) return {};
  const std::lock_guard<std::mutex> lock(reused_);
  receiving_ = bytes;
  return {places_[receiving_slot()], bytes};
}

Result<const FieldView*> FieldSlots::verify() {
  if (receiving_ == 0) return Error::kTruncated;
  const std::uint32_t slot = receiving_slot();
  const auto view = FieldView::parse({places_[slot], receiving_});
  if (!view) {
    abandon();
    return view.error();
  }
  views_[slot] = *view;
  sums_[slot].take(view->image);
  seals_[slot].close(views_[slot]);
  verified_ = true;
  return &views_[slot];
}

Result<std::uint32_t> FieldSlots::commit(std::uint32_t author) { return commit(Origin{author}); }

Result<std::uint32_t> FieldSlots::commit_patched(std::uint64_t hash, std::uint32_t author) {
  const ActiveField before = published();
  return commit(Origin{author, 0, before.generation, before.surface, hash});
}

Result<std::uint32_t> FieldSlots::commit(Origin origin) {
  if (!verified_) return Error::kTruncated;
  const std::uint32_t slot = receiving_slot();
  abandon();
  origin.generation = next_generation();
  origins_[slot] = origin;
  publish(slot);
  return generation_;
}

bool FieldSlots::take_back() {
  const std::uint32_t felt =
      acknowledged_.load(std::memory_order_acquire);  // once: a tick that takes the other one right now goes back, too
  if (felt == published_.load(std::memory_order_relaxed)) return false;
  publish(felt & kSlot);
  return true;
}

bool FieldSlots::clear() {
  if (!free()) return false;
  abandon();
  publish(kNone);
  return true;
}

ActiveField FieldSlots::published() const { return field_in(published_.load(std::memory_order_relaxed)); }

ActiveField FieldSlots::field_in(std::uint32_t word) const {
  const std::uint32_t slot = word & kSlot;
  if (slot == kNone) return {};
  const Origin& origin = origins_[slot];
  ActiveField field{&views_[slot], word >> 2, origin.author, &sums_[slot], 0, word >> 2, 0};
  if (origin.patched_from != 0 && origin.generation == field.generation) {
    field.patched_from = origin.patched_from;
    field.surface = origin.surface;
    field.hash = origin.hash;
  }
  return field;
}

ActiveField FieldSlots::field() {
  const std::uint32_t word = published_.load(std::memory_order_acquire);
  if (word != active_) {
    active_ = word;
    acknowledged_.store(word, std::memory_order_release);
  }
  return field_in(word);
}

std::uint32_t FieldSlots::damaged_in(std::size_t part) {
  const std::lock_guard<std::mutex> lock(reused_);
  const std::uint32_t word = published_.load(std::memory_order_acquire);
  if ((word & kSlot) == kNone) return 0;
  const std::size_t slot = word & kSlot;
  bool whole = seals_[slot].holds(views_[slot]);
  const std::span<const std::uint8_t> image = whole ? views_[slot].image : std::span<const std::uint8_t>{};
  for (std::size_t block = border(image.size(), part); block < border(image.size(), part + 1); ++block) {
    whole &= sums_[slot].holds(image, block);
  }
  return whole ? 0 : word >> 2;
}

ActiveField FieldSlots::field_of(std::uint32_t generation) {
  const auto is_of = [generation](std::uint32_t word) { return generation_in(word) == generation; };
  const std::uint32_t word = published_.load(std::memory_order_acquire);
  if (is_of(word) && word != guarded_field_) {
    guarded_field_ = word;
    guard_acknowledged_.store(word, std::memory_order_release);
  }
  return is_of(guarded_field_) && generation != 0 ? field_in(guarded_field_) : ActiveField{};
}

void FieldSlots::publish(std::uint32_t slot) {
  generation_ = next_generation();
  published_.store(generation_ << 2 | slot, std::memory_order_release);
}

}  // namespace isotouch::loop
