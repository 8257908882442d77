/// From the bytes of an upload to a field that is felt: unpacked, checked completely, stored, and handed to the tick. The field before stays whenever
/// something is wrong.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/loop/clock.h"
#include "firmware/loop/field_slots.h"
#include "firmware/store/field_store.h"
#include "shared/field_patch.h"
#include "shared/field_view.h"
#include "shared/files/refusal.h"
#include "shared/packed_field.h"
#include "shared/protocol_messages.h"

struct ZSTD_DCtx_s;

namespace isotouch::store {

/// Says whether this device may render a field: or why not.
using FieldCheck = std::function<Refusal(const FieldView&)>;

/// What is said of a field that does not fit, with both sizes in bytes.
std::string too_large(std::uint64_t image_bytes, std::size_t limit);

/// A field that was handed to the tick.
struct PublishedField {
  std::uint64_t image_hash = 0;  ///< 0 = none
  std::uint32_t generation = 0;
  protocol::Text name;  ///< for people; may be empty
  Stiffness stiffness;  ///< the field's own; 0 without a field

  protocol::Accepted accepted() const { return {image_hash, generation}; }
};

struct IntakeOutcome {
  Refusal refusal;       ///< none: the field is active
  PublishedField field;  ///< the one that is active now
};

/// Used by one thread, except where it says otherwise. All its memory is taken when it is made.
class FieldIntake {
 public:
  /// slots     their capacity is the largest image
  /// store     nullptr: fields do not outlive the program
  /// check     beyond FieldView::parse; may be empty
  FieldIntake(loop::FieldSlots& slots, FieldStore* store, loop::Clock& clock, FieldCheck check);
  ~FieldIntake();
  FieldIntake(const FieldIntake&) = delete;
  FieldIntake& operator=(const FieldIntake&) = delete;

  /// From now on every patch is told before the tick may feel it: the hash of the image after, and its bytes. Before the first patch.
  void tell_patches(std::function<void(std::uint64_t, std::span<const std::uint8_t>)> told) { told_ = std::move(told); }

  bool keeps_fields() const { return store_ != nullptr; }
  std::size_t image_limit() const { return slots_.capacity(); }
  /// Where an upload is put together, by whoever lets no other function run meanwhile. Room for the packed form of every image that there may be.
  std::span<std::uint8_t> upload() { return upload_; }

  /// Takes over what stands at the front of `upload()`. Waits until the tick has taken the field over, for at most two seconds. What is refused is
  /// neither felt later nor there at the next start.
  ///
  /// promised  what was said before the bytes came: they must keep it
  /// author    who sent it
  IntakeOutcome accept(const protocol::Begin& promised, std::uint32_t author = kNobody);

  /// Applies the patch that stands at the front of `upload()` to the field that is felt. It waits as `accept` does. Nothing is stored: the next start
  /// begins with the field that was stored last. What is refused changes nothing.
  ///
  /// bytes     of the patch, at most `upload().size()`
  /// author    who sent it
  IntakeOutcome patch(std::uint64_t bytes, std::uint32_t author = kNobody);

  /// The same for a stored field.
  IntakeOutcome select(std::uint64_t wanted, std::uint32_t author = kNobody);

  /// Copies the image of the field that was handed to the tick last, so that it can be read while patches change the field.
  ///
  /// returns   refused: there is no field
  IntakeOutcome copy();

  /// What `copy` copied; empty where there is none, or an upload has taken its memory. By whoever lets no other function run meanwhile.
  std::span<const std::uint8_t> copied() const { return std::span(work_).first(copied_); }
  std::uint64_t copied_hash() const { return copied_hash_; }

  /// Begins with the field that was active last; before the tick's first step, does not wait.
  ///
  /// returns   there should be one and is none
  Refusal begin_with_active();

  /// Begins with a field that is nowhere stored, instead: packed, or an image as it is.
  ///
  /// name      for people
  /// returns   why it was not loaded
  Refusal begin_with(std::span<const std::uint8_t> field, std::string_view name);

  /// Asks `check` again about the newest field, when what it answers may have changed. A field that is refused now is taken away from the tick; the
  /// next start may begin with it. Any thread.
  ///
  /// refusal   what the check says and what to do; none where the field stays
  /// returns   false: another field is just being taken over, ask later
  bool check_again(Refusal& refusal);

  /// What is stored, oldest first; empty without a store.
  std::vector<StoredField> stored();

  /// The field handed to the tick last: hash and generation belong together. Any thread but the tick's.
  PublishedField published() const;

  /// Of one of the fields handed to the tick lately, also of one that the tick has left since; any thread but the tick's.
  ///
  /// returns   its hash; 0: none, or too long ago
  std::uint64_t hash_of(std::uint32_t generation) const;

 private:
  /// What the store was like before a request.
  struct Before {
    std::optional<std::uint64_t> active;
    bool held = false;  ///< the field that the request is about
  };
  /// What is to be handed over, and for whom.
  struct Wish {
    std::uint64_t hash = 0;
    protocol::Text name;
    std::uint32_t author = kNobody;
    bool is_patched = false;  ///< from the field that is felt; stored nowhere
  };

  Before store_before(std::uint64_t hash);
  Refusal unpack(std::span<const std::uint8_t> bytes, std::uint64_t hash);
  Refusal unpack(const PackedField& packed);
  Refusal apply(const FieldPatch& patch);
  Refusal judge(const FieldView& field) const;
  Refusal keep(const protocol::Begin& field, std::span<const std::uint8_t> packed);
  IntakeOutcome activate(const Wish& wish, Refusal refusal, const Before& before);
  Refusal publish(const Wish& wish);
  void remember(std::uint64_t hash, const protocol::Text& name);
  protocol::Text stored_name(std::uint64_t hash);
  bool was_taken_over();
  Refusal take_back(const Wish& wish, const PublishedField& felt, const Before& before);

  loop::FieldSlots& slots_;
  FieldStore* store_;
  loop::Clock& clock_;
  FieldCheck check_;
  std::function<void(std::uint64_t, std::span<const std::uint8_t>)> told_;
  std::vector<std::uint8_t> upload_;
  std::vector<std::uint8_t> work_;  ///< residuals while a field is unpacked, else what was copied
  std::size_t copied_ = 0;
  std::uint64_t copied_hash_ = 0;
  ZSTD_DCtx_s* context_;
  std::mutex exchanging_;  ///< held while the slots or the store change

  static constexpr std::size_t kRemembered = 16;
  mutable std::mutex
      handing_over_;  ///< held while a field is handed to the tick, so that nobody hears of a generation before its hash is here
  std::array<PublishedField, kRemembered> handed_over_{};  ///< a circle
  std::size_t newest_ = 0;
};

}  // namespace isotouch::store
