/// Two places for a field: the tick uses one while an upload fills the other. Two atomic variables, no lock.
///
///   empty      upload: `begin` with a size that fits        → receiving
///   receiving  upload: `verify`, FieldView::parse succeeded  → verified
///   verified   upload: `commit`, or of a patch `commit_patched` → published by a generation
///   published  tick: `field` at the start of a tick         → active; the other one retires
///   retiring   upload: has seen the acknowledgements        → empty
///   published  upload: `take_back`, the tick does not come  → retiring; the active one is published anew
///
/// A lost connection leaves `receiving` without effect; a refused image is never seen by the tick.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "firmware/loop/block_sums.h"
#include "firmware/loop/seal.h"
#include "shared/field_view.h"
#include "shared/result.h"
#include "shared/tick_io.h"

namespace isotouch::loop {

/// The field of one tick.
struct ActiveField {
  const FieldView* view = nullptr;  ///< nullptr: none
  std::uint32_t generation = 0;     ///< 0 = none; another number = another field, or a patched one
  std::uint32_t author = kNobody;   ///< who sent or chose it
  const BlockSums* sums = nullptr;  ///< of its image
  std::uint32_t patched_from = 0;   ///< the generation that a patch made this one from; 0 = it is a field of its own
  std::uint32_t surface = 0;        ///< the generation of the field that all patches since were made to; 0 = none
  std::uint64_t hash = 0;           ///< of the image; only of a patched one, else 0
};

class FieldSlots {
 public:
  /// bytes     largest image, each; both places are allocated and touched here and never again
  explicit FieldSlots(std::size_t bytes);

  std::size_t capacity() const { return capacity_; }

  // --- upload: one thread at a time ---

  /// True when `begin` would succeed: no place still waits for the tick to leave it.
  bool free() const;

  /// Claims the place that the tick does not use. What was received there and not committed is forgotten. Waits while `damaged_in` reads a part.
  ///
  /// bytes     of the unpacked image, at most `capacity()`
  /// returns   where to write the image, 64-byte aligned; empty: too large, or the tick has not taken the last field over yet
  std::span<std::uint8_t> begin(std::size_t bytes);

  /// Checks what was received: the only place where an image is parsed.
  ///
  /// returns   the field, for whoever else judges it; valid until the next `begin`
  /// fails     as FieldView::parse; kTruncated: nothing was begun. The place is receiving no longer, the tick keeps its field
  Result<const FieldView*> verify();

  /// Hands what was verified to the tick.
  ///
  /// author    who sent or chose it
  /// returns   the generation by which the tick will know it
  /// fails     kTruncated: nothing was verified
  Result<std::uint32_t> commit(std::uint32_t author = kNobody);

  /// The same of a patched image: the surface that is felt has moved. What was published last, and has been taken over, is what it was made from.
  ///
  /// hash      of the image
  Result<std::uint32_t> commit_patched(std::uint64_t hash, std::uint32_t author = kNobody);

  /// Takes back what `commit` handed over and the tick did not take: it goes on with the field before, by a new generation.
  ///
  /// returns   false: the tick has taken it meanwhile, it stays
  bool take_back();

  /// Gives up what was begun.
  void abandon() { receiving_ = 0, verified_ = false; }

  /// Takes the field away from the tick: it goes on without one.
  ///
  /// returns   false: the tick has not taken the last field over yet
  bool clear();

  /// The generation that the tick, and the guard where there is one, have taken over; equal to that of `commit` once the new field is felt.
  std::uint32_t acknowledged() const {
    const std::uint32_t felt = acknowledged_.load(std::memory_order_acquire);
    return (guarded_ ? guard_acknowledged_.load(std::memory_order_acquire) : felt) == felt ? felt >> 2 : 0;
  }

  /// The newest published field, also when the tick has not taken it over yet. Valid until the next `begin`.
  ActiveField published() const;
  /// Its generation; 0: none. Any thread.
  std::uint32_t published_generation() const { return generation_in(published_.load(std::memory_order_relaxed)); }

  // --- memory check ---

  /// The number of parts of an image, for `damaged_in`.
  static constexpr std::size_t kParts = 20;

  /// Hashes the view of the published image and one part of the image again, up to 51 MiB of the largest. Waits while an upload begins, for a moment.
  ///
  /// returns   the field's generation where it is not what `verify` saw, else 0
  std::uint32_t damaged_in(std::size_t part);

  // --- tick ---

  /// The field of this tick; takes a new one over.
  ///
  /// tick      yes
  ActiveField field();

  // --- guard ---

  /// A guard reads along, too. Before the first tick.
  void expect_guard() { guarded_ = true; }

  /// The field with which a tick made a command; the guard keeps it until it asks for another. One thread, which may be the tick's.
  ///
  /// returns   without a view: there is none, or the upload has taken it back
  /// tick      yes
  ActiveField field_of(std::uint32_t generation);

 private:
  static constexpr std::uint32_t kSlot = 3, kNone = 2;  // a word: generation * 4 + slot

  /// Of the image of a place, and the generation by which it was published first: published again, it is another field.
  struct Origin {
    std::uint32_t author = kNobody, generation = 0, patched_from = 0, surface = 0;
    std::uint64_t hash = 0;
  };

  static std::uint32_t generation_in(std::uint32_t word) { return (word & kSlot) == kNone ? 0 : word >> 2; }
  ActiveField field_in(std::uint32_t word) const;
  std::uint32_t receiving_slot() const { return (published_.load(std::memory_order_relaxed) & kSlot) == 0 ? 1 : 0; }
  Result<std::uint32_t> commit(Origin origin);
  std::uint32_t next_generation() const { return generation_ % ((1U << 30) - 1) + 1; }
  void publish(std::uint32_t slot);

  std::size_t capacity_;
  std::vector<std::uint64_t> memory_;
  std::array<std::uint8_t*, 2> places_{};
  std::array<FieldView, 2> views_{};
  std::array<Origin, 2> origins_{};
  std::array<BlockSums, 2> sums_;  ///< of the images as they were verified
  std::array<Seal, 2> seals_{};    ///< of the views
  std::mutex reused_;              ///< a place is not used again while it is read
  std::size_t receiving_ = 0;      ///< bytes; 0 = nothing was begun
  bool verified_ = false;          ///< what was received is a field
  std::uint32_t generation_ = 0;
  std::atomic<std::uint32_t> published_{kNone};
  std::atomic<std::uint32_t> acknowledged_{kNone};
  std::atomic<std::uint32_t> guard_acknowledged_{kNone};
  bool guarded_ = false;
  std::uint32_t active_ = kNone;         ///< the tick's own
  std::uint32_t guarded_field_ = kNone;  ///< the guard's own
};

}  // namespace isotouch::loop
