#include "firmware/recording/recorder.h"

#include <algorithm>
#include <utility>

namespace isotouch::recording {

namespace {
constexpr auto kFault = static_cast<std::uint16_t>(SupervisorState::kFault);
constexpr const char* kTooSlow = "ticks were lost because the recorder was too slow";
}  // namespace

Recorder::Recorder(RecorderSettings settings, loop::TraceRing& ring, loop::TraceRing* passed_on, loop::Requests& requests,
                   std::function<std::uint64_t(std::uint32_t)> hash_of, std::function<void(const std::string&)> tell)
    : settings_(std::move(settings)),
      ring_(ring),
      passed_on_(passed_on),
      requests_(requests),
      hash_of_(std::move(hash_of)),
      tell_(std::move(tell)),
      memory_(settings_.state.empty() ? 0 : settings_.remembered + 1 + settings_.after_fault) {
  if (!settings_.state.empty()) keep_last_ticks();
}

Recorder::~Recorder() {
  drain();
  const std::lock_guard guard(mutex_);
  if (save_in_ > 0) save();
  if (writer_.is_open()) end("the program ends", Outcome::kAsAsked);
  last_ticks_.end();
}

/// What a killed run left becomes a file of its own; then the place is this run's. Where that cannot be, the place stays what it is.
void Recorder::keep_last_ticks() {
  const std::string place = settings_.state + "/last-ticks";
  TraceHeader header;
  const std::vector<LastTick> left = LastTicks::read(place, header);  // an orderly end leaves nothing
  if (!left.empty()) {
    const std::string path = saved("crash").next();
    TickWriter writer;
    Refusal refusal = writer.begin(path, header);
    for (const LastTick& last : left) {
      if (!refusal) refusal = writer.append(last.tick);
    }
    if (Refusal unfinished = writer.finish(left.back().field_hash)) refusal = std::move(unfinished);
    if (refusal) return tell_(refusal.sentence() + "; they stay in " + place + ", and this run keeps none: free space and start again");
    tell_(path + ": the last ticks of the run before");
    saved("crash").forget_oldest(settings_.most_kept);
  }
  if (const Refusal refusal = last_ticks_.begin(place, settings_.header, memory_.size())) tell_(refusal.sentence());
}

/// What is saved of a kind.
NumberedTraces Recorder::saved(const char* kind) const { return NumberedTraces(settings_.state + "/" + kind + ".trace"); }

Refusal Recorder::start(const std::string& path) {
  const std::lock_guard guard(mutex_);
  if (writer_.is_open()) return "a recording is under way: " + writer_.path();
  begun_ = false;
  generation_ = 0;
  hash_ = 0;
  if (Refusal refusal = patch_writer_.begin(path)) return refusal;
  if (Refusal refusal = writer_.begin(path, settings_.header, files::Leftover::kRefuse)) return refusal;
  keep_patches(true);
  requests_.ask(kRequestRestart);
  return {};
}

void Recorder::stop(std::uint64_t newest) {
  const std::lock_guard guard(mutex_);
  if (!writer_.is_open()) return;
  if (begun_ && next_ <= newest) return end(kTooSlow);
  end("as asked", Outcome::kAsAsked);
}

void Recorder::discard() {
  const std::lock_guard guard(mutex_);
  if (!writer_.is_open()) return;
  keep_patches(false);
  writer_.discard();
  patch_writer_.discard();
  tell_(writer_.path() + ": the recording begins anew");
}

void Recorder::tell_patch(std::uint64_t hash_after, std::span<const std::uint8_t> patch) {
  const std::lock_guard guard(patches_mutex_);
  const auto is_too_much = [&] {
    std::size_t bytes = patch.size();
    for (const Patch& kept : patches_) bytes += kept.bytes.size();
    return patches_.size() == kPatchesKept || bytes > kPatchBytesKept;
  };
  while (!patches_.empty() && (!keeps_patches_ || is_too_much())) patches_.pop_front();
  patches_.push_back({hash_after, {patch.begin(), patch.end()}});
}

/// The last that was told stays: its tick may come after a recording has begun.
void Recorder::keep_patches(bool wanted) {
  const std::lock_guard guard(patches_mutex_);
  keeps_patches_ = wanted;
}

void Recorder::drain() {
  const std::lock_guard guard(mutex_);
  for (loop::TickRecord tick; ring_.pop(tick);) take(tick);
}

void Recorder::take(const loop::TickRecord& tick) {
  if (passed_on_ != nullptr) passed_on_->push(tick);
  if (writer_.is_open()) record(tick);
  if (!memory_.empty()) remember(tick);
  state_ = tick.out.state;
  condition_.put(condition_of(tick));
}

void Recorder::record(const loop::TickRecord& tick) {
  if (!begun_ && (tick.in.requests & kRequestRestart) == 0) return;
  if (!begun_) next_ = tick.number;
  begun_ = true;
  if (tick.number != next_) return end(kTooSlow);
  ++next_;
  const std::uint32_t generation = tick.in.field_generation;
  if ((tick.in.requests & kRequestMoved) != 0) {
    if (const Refusal refusal = record_patch(tick.in.moved_to)) return end(refusal.sentence());
    generation_ = generation;
  }
  if (generation_ != 0 && generation != 0 && generation != generation_) return end("another field was loaded");
  if (generation != 0) generation_ = generation;
  if (generation_ != 0 && hash_ == 0) writer_.name_field(hash_ = hash_of_(generation_));
  if (const Refusal refusal = writer_.append(tick)) end(refusal.sentence());
}

/// The patch that leads there; those before it were never taken over.
Refusal Recorder::record_patch(std::uint32_t moved_to) {
  Patch patch;
  {
    const std::lock_guard guard(patches_mutex_);
    const auto found = std::find_if(patches_.begin(), patches_.end(),
                                    [=](const Patch& one) { return static_cast<std::uint32_t>(one.hash_after) == moved_to; });
    if (found == patches_.end()) return "a patch was not kept until its tick came";
    patch = std::move(*found);
    patches_.erase(patches_.begin(), found + 1);
  }
  if (hash_ == 0) return "the field was patched before its name was known";  // the trace must name the field before
  return patch_writer_.append(patch.bytes);
}

void Recorder::remember(const loop::TickRecord& tick) {
  const std::uint32_t generation = tick.in.field_generation;
  const bool is_known = generation == newest_.tick.in.field_generation && newest_.field_hash != 0;
  if (!is_known) newest_.field_hash = generation == 0 ? 0 : hash_of_(generation);
  newest_.tick = tick;
  // A run that begins in fault, because the one before crashed, has nothing to show of it.
  if (tick.out.state == kFault && state_ != kFault && save_in_ == 0 && remembered_ > 0) {
    faulted_ = tick.number;
    faulted_hash_ = newest_.field_hash;  // another field may come before it is saved
    save_in_ = settings_.after_fault + 1;
  }
  last_ticks_.put(newest_);
  memory_[end_] = tick;
  end_ = (end_ + 1) % memory_.size();
  remembered_ = std::min(remembered_ + 1, memory_.size());
  if (save_in_ > 0 && --save_in_ == 0) save();
}

void Recorder::end(const std::string& why, Outcome outcome) {
  keep_patches(false);
  const std::string& path = writer_.path();
  const Refusal refusal = writer_.finish(hash_);
  const std::uint64_t records = writer_.records();
  if (records == 0) patch_writer_.discard();
  const Refusal without = patch_writer_.finish();  // after the trace: patches alone would stand beside an older one
  if (refusal) outcome = records > 0 ? Outcome::kEndedEarly : Outcome::kLost;
  if (without) outcome = Outcome::kLost;
  outcome_ = std::max(outcome_.load(), outcome);
  if (refusal) return tell_(refusal.sentence());
  if (without) return tell_(without.sentence() + "; without them " + path + " does not replay");
  tell_(records == 0 ? path + ": nothing was recorded" : path + ": " + std::to_string(records) + " ticks recorded; " + why);
}

/// The fault with what is before and after it, as far as neither another field nor a loss of ticks separates them.
void Recorder::save() {
  save_in_ = 0;
  if (saved_++ >= settings_.most_saved) return;
  const auto at = [&](std::size_t i) -> const loop::TickRecord& {
    return memory_[(end_ + memory_.size() - remembered_ + i) % memory_.size()];
  };
  std::size_t from = 0;
  while (at(from).number != faulted_) ++from;  // it is there: no more ticks came since than are kept after a fault
  const std::uint32_t generation = at(from).in.field_generation;
  const auto same_field = [&](std::size_t i) { return at(i).in.field_generation == generation || at(i).in.field_generation == 0; };
  std::size_t to = from + 1;
  while (to < remembered_ && same_field(to) && at(to).number == at(to - 1).number + 1) ++to;
  while (from > 0 && same_field(from - 1) && at(from - 1).number + 1 == at(from).number) --from;
  const std::string path = saved("fault").next();
  TickWriter writer;
  Refusal refusal = writer.begin(path, settings_.header);
  for (std::size_t i = from; i < to && !refusal; ++i) refusal = writer.append(at(i));
  if (Refusal unfinished = writer.finish(faulted_hash_)) refusal = std::move(unfinished);
  tell_(refusal ? refusal.sentence() : path + ": the ticks around the fault");
  if (!refusal) saved("fault").forget_oldest(settings_.most_kept);
}

}  // namespace isotouch::recording
