#include "host/server/outbox.h"

#include <utility>

namespace isotouch::server {

void Outbox::put(const Shared& message) {
  if (message->topic != Topic::kTicks) {
    if (message->topic == Topic::kLink) forget_controller();
    newest_[static_cast<std::size_t>(message->topic)] = message;
    return;
  }
  if (batches_.size() == kMaxBatches) {
    batches_.pop_front();
    ++dropped_;
  }
  batches_.push_back(message);
}

/// What was said before a controller came or went would be read as if it were now.
void Outbox::forget_controller() {
  batches_.clear();
  for (const Topic topic : {Topic::kState, Topic::kStatus}) newest_[static_cast<std::size_t>(topic)] = nullptr;
}

std::optional<Shared> Outbox::take() {
  for (Shared& waiting : newest_) {
    if (waiting) return std::exchange(waiting, nullptr);
  }
  if (batches_.empty() || unseen_ == kMaxUnseen) return std::nullopt;
  Shared first = std::move(batches_.front());
  batches_.pop_front();
  ++unseen_;
  return first;
}

}  // namespace isotouch::server
