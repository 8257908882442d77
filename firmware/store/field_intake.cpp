#include "firmware/store/field_intake.h"

#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <utility>

#include "shared/packed_field.h"

namespace isotouch::store {

namespace {

constexpr std::int64_t kPatience = 2'000'000'000;
constexpr std::int64_t kNap = 200'000;  ///< a patch waits for the tick, and whoever sent it for the answer

/// The packed form of any image of so many bytes: what cannot be compressed is a little longer.
std::size_t packed_limit(std::size_t image_bytes) { return packed_layout::kHeaderBytes + ZSTD_compressBound(image_bytes); }

std::string hash_text(std::uint64_t hash) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

std::string unusable(Error error) {
  if (error == Error::kBadMagic) return "it is no field; make one of a scan or a mesh with isotouch build";
  return std::string("the field is not usable: ") + describe(error) + "; build it again and send it again";
}

}  // namespace

std::string too_large(std::uint64_t image_bytes, std::size_t limit) {
  return "the field takes " + std::to_string(image_bytes) + " bytes, and [limits] field_mib allows " + std::to_string(limit) +
         " bytes; raise that setting of the controller, or build the field with a larger --voxel";
}

FieldIntake::FieldIntake(loop::FieldSlots& slots, FieldStore* store, loop::Clock& clock, FieldCheck check)
    : slots_(slots),
      store_(store),
      clock_(clock),
      check_(std::move(check)),
      upload_(packed_limit(slots.capacity())),
      work_(slots.capacity()),
      context_(ZSTD_createDCtx()) {
  assert(context_ != nullptr);
}

FieldIntake::~FieldIntake() { ZSTD_freeDCtx(context_); }

IntakeOutcome FieldIntake::accept(const protocol::Begin& promised, std::uint32_t author) {
  const std::lock_guard guard(exchanging_);
  const auto packed = std::span(upload_).first(static_cast<std::size_t>(promised.packed_bytes));
  const Before before = store_before(promised.image_hash);
  Refusal refusal = unpack(packed, promised.image_hash);
  if (!refusal && store_ != nullptr) refusal = keep(promised, packed);
  return activate({promised.image_hash, promised.name, author}, std::move(refusal), before);
}

IntakeOutcome FieldIntake::patch(std::uint64_t bytes, std::uint32_t author) {
  const std::lock_guard guard(exchanging_);
  const Result<FieldPatch> patch = FieldPatch::parse(std::span(upload_).first(static_cast<std::size_t>(bytes)));
  if (!patch) return {std::string("the patch is not usable: ") + describe(patch.error()) + "; send the whole field", published()};
  Refusal refusal = apply(*patch);
  if (!refusal && told_) told_(patch->hash_after, std::span(upload_).first(static_cast<std::size_t>(bytes)));
  return activate({patch->hash_after, published().name, author, true}, std::move(refusal), {});
}

IntakeOutcome FieldIntake::select(std::uint64_t wanted, std::uint32_t author) {
  const std::lock_guard guard(exchanging_);
  if (store_ == nullptr) return {"this controller stores no fields; upload one, or start it with a state folder", {}};
  const Before before = store_before(wanted);
  const StoreResult<std::size_t> bytes = store_->read(wanted, upload_);
  if (!bytes && bytes.error() == StoreError::kNotFound) return {"no field of this hash is stored; list them with: isotouchctl fields", {}};
  if (!bytes) return {std::string("the stored field cannot be read: ") + describe(bytes.error()) + "; upload it again", {}};
  Refusal refusal = unpack(std::span(upload_).first(*bytes), wanted);
  if (!refusal) {
    const StoreResult<void> switched = store_->set_active(wanted);
    if (!switched) refusal = std::string("the choice cannot be stored: ") + describe(switched.error()) + "; check the state folder";
  }
  return activate({wanted, stored_name(wanted), author}, std::move(refusal), before);
}

IntakeOutcome FieldIntake::copy() {
  const std::lock_guard guard(exchanging_);
  const loop::ActiveField field = slots_.published();
  copied_ = 0;
  if (field.view == nullptr) return {"no field is loaded that could be read; upload one", {}};
  const std::span<const std::uint8_t> image = field.view->image;
  std::copy(image.begin(), image.end(), work_.begin());
  copied_ = image.size();
  copied_hash_ = published().image_hash;
  return {{}, published()};
}

Refusal FieldIntake::begin_with_active() {
  if (store_ == nullptr) return {};
  const std::optional<std::uint64_t> wanted = store_->active();
  if (!wanted) return {};
  const StoreResult<std::size_t> bytes = store_->read(*wanted, upload_);
  if (!bytes) return std::string("the field that was active last cannot be read: ") + describe(bytes.error()) + "; upload one";
  Refusal refusal = unpack(std::span(upload_).first(*bytes), *wanted);
  if (!refusal) refusal = publish({*wanted, stored_name(*wanted), kNobody});
  slots_.abandon();
  return refusal ? Refusal("the field that was active last was not loaded: " + refusal.sentence()) : Refusal();
}

Refusal FieldIntake::begin_with(std::span<const std::uint8_t> field, std::string_view name) {
  std::uint64_t hash = 0;
  Refusal refusal;
  if (PackedField::has_magic(field)) {
    const Result<PackedField> packed = PackedField::parse(field);
    if (!packed) return unusable(packed.error());
    hash = packed->image_hash;
    refusal = unpack(*packed);
  } else {
    if (field.size() > slots_.capacity()) return too_large(field.size(), slots_.capacity());
    const std::span<std::uint8_t> image = slots_.begin(field.size());
    if (image.empty()) return unusable(Error::kBadSize);
    std::copy(field.begin(), field.end(), image.begin());
    const Result<const FieldView*> view = slots_.verify();
    if (!view) return unusable(view.error());
    hash = (*view)->hash();
    refusal = judge(**view);
  }
  if (!refusal) refusal = publish({hash, protocol::Text::of(name), kNobody});
  slots_.abandon();
  return refusal;
}

bool FieldIntake::check_again(Refusal& refusal) {
  const std::unique_lock guard(exchanging_, std::try_to_lock);
  if (!guard) return false;
  const loop::ActiveField field = slots_.published();
  const Refusal why = field.view == nullptr ? Refusal() : judge(*field.view);
  if (!why) return true;
  {
    const std::lock_guard handing_over(handing_over_);
    if (!slots_.clear()) return false;
    remember(0, {});
  }
  refusal = "the field was unloaded: " + why.sentence() + " and load it again";
  return true;
}

std::vector<StoredField> FieldIntake::stored() { return store_ == nullptr ? std::vector<StoredField>{} : store_->list(); }

FieldIntake::Before FieldIntake::store_before(std::uint64_t hash) {
  if (store_ == nullptr) return {};
  return {store_->active(), store_->holds(hash)};
}

Refusal FieldIntake::judge(const FieldView& field) const { return check_ ? check_(field) : std::string(); }

/// A packed field that was promised by its hash.
Refusal FieldIntake::unpack(std::span<const std::uint8_t> bytes, std::uint64_t hash) {
  const Result<PackedField> packed = PackedField::parse(bytes);
  if (!packed) return unusable(packed.error());
  if (packed->image_hash != hash) return unusable(Error::kBadChecksum);
  return unpack(*packed);
}

/// Into the slot that the tick does not use.
Refusal FieldIntake::unpack(const PackedField& packed) {
  if (packed.image_bytes > slots_.capacity()) return too_large(packed.image_bytes, slots_.capacity());
  const auto image_bytes = static_cast<std::size_t>(packed.image_bytes);
  if (!slots_.free()) return "the controller is still loading the previous field; try again in a moment";
  const std::span<std::uint8_t> image = slots_.begin(image_bytes);
  copied_ = 0;
  const auto residuals = std::span(work_).first(static_cast<std::size_t>(packed.residual_bytes()));
  const auto unpacked = isotouch::unpack(packed, residuals, image, [this](auto frame, auto out) {
    return ZSTD_decompressDCtx(context_, out.data(), out.size(), frame.data(), frame.size());
  });
  if (!unpacked) return unusable(unpacked.error());
  const Result<const FieldView*> view = slots_.verify();
  return view ? judge(**view) : unusable(view.error());
}

/// Into the slot that the tick does not use, from the one that it uses.
Refusal FieldIntake::apply(const FieldPatch& patch) {
  if (patch.image_bytes() > slots_.capacity()) return too_large(patch.image_bytes(), slots_.capacity());
  if (!slots_.free()) return "the controller is still loading the previous field; try again in a moment";
  const loop::ActiveField before = slots_.published();
  if (before.view == nullptr) return "no field is loaded that the patch could change; send the whole field";
  if (const std::uint64_t felt = published().image_hash; felt != patch.hash_before) {
    return "this patch is for the field " + hash_text(patch.hash_before) + ", and the controller has " + hash_text(felt) +
           "; send the whole field";
  }
  const auto image = isotouch::apply(patch, *before.view, slots_.begin(patch.image_bytes()));
  if (!image) return std::string("the patch does not fit: ") + describe(image.error()) + "; send the whole field";
  const Result<const FieldView*> view = slots_.verify();
  return view ? judge(**view) : unusable(view.error());
}

/// Stored and chosen for the next start; when that fails the choice before stays.
Refusal FieldIntake::keep(const protocol::Begin& field, std::span<const std::uint8_t> packed) {
  const std::optional<std::uint64_t> before = store_->active();
  StoreResult<void> stored = store_->put(field.image_hash, field.name.view(), packed);
  if (stored) stored = store_->set_active(field.image_hash);
  if (stored) return {};
  if (before) (void)store_->set_active(*before);
  return std::string("the field is good but cannot be stored: ") + describe(stored.error()) +
         "; check the controller's state folder and send it again";
}

/// What was unpacked becomes the tick's, unless something spoke against it.
IntakeOutcome FieldIntake::activate(const Wish& wish, Refusal refusal, const Before& before) {
  const PublishedField felt = handed_over_[newest_];  // nobody else writes it while `exchanging_` is held
  if (!refusal) refusal = publish(wish);
  if (!refusal && !was_taken_over()) refusal = take_back(wish, felt, before);
  slots_.abandon();
  return {std::move(refusal), published()};
}

Refusal FieldIntake::publish(const Wish& wish) {
  const std::lock_guard handing_over(handing_over_);
  const Result<std::uint32_t> generation = wish.is_patched ? slots_.commit_patched(wish.hash, wish.author) : slots_.commit(wish.author);
  if (!generation) return unusable(generation.error());
  remember(wish.hash, wish.name);
  return {};
}

protocol::Text FieldIntake::stored_name(std::uint64_t hash) {
  for (const StoredField& field : store_->list()) {
    if (field.hash == hash) return protocol::Text::of(field.name);
  }
  return {};
}

/// What was just handed over. While `handing_over_` is held.
void FieldIntake::remember(std::uint64_t hash, const protocol::Text& name) {
  newest_ = (newest_ + 1) % kRemembered;
  const loop::ActiveField field = slots_.published();
  handed_over_[newest_] = {hash, field.generation, name, field.view == nullptr ? Stiffness{} : field.view->stiffness};
}

PublishedField FieldIntake::published() const {
  const std::lock_guard handing_over(handing_over_);
  return handed_over_[newest_];
}

std::uint64_t FieldIntake::hash_of(std::uint32_t generation) const {
  const std::lock_guard handing_over(handing_over_);
  const auto found =
      std::find_if(handed_over_.begin(), handed_over_.end(), [&](const PublishedField& one) { return one.generation == generation; });
  return generation != 0 && found != handed_over_.end() ? found->image_hash : 0;
}

/// The tick does not come: as if nothing had been sent. returns no refusal: the tick has come after all
Refusal FieldIntake::take_back(const Wish& wish, const PublishedField& felt, const Before& before) {
  {
    const std::lock_guard handing_over(handing_over_);
    if (!slots_.take_back()) return {};
    remember(felt.image_hash, felt.name);
  }
  std::string refusal = "the field is good, but the controller's loop does not run, so the field is not loaded";
  if (store_ != nullptr && !wish.is_patched && !store_->take_back(wish.hash, before.active, !before.held))
    refusal += ", although the next start may load it";
  return refusal + "; restart the controller";
}

bool FieldIntake::was_taken_over() {
  const std::int64_t until = clock_.now_ns() + kPatience;
  const std::uint32_t wanted = published().generation;
  while (slots_.acknowledged() != wanted) {
    const std::int64_t now = clock_.now_ns();
    if (now >= until) return false;
    clock_.sleep_until_ns(now + kNap);
  }
  return true;
}

}  // namespace isotouch::store
