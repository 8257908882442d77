#include "host/server/outbox.h"

#include <utility>

namespace isotouch::server {

void Outbox::put(const Shared& message) {
  if (message->topic != Topic::kTicks) {
    newest_[static_cast<std::size_t>(message->topic)] = message;
    return;
  }
  if (batches_.size() == kMaxBatches) {
    batches_.pop_front();
    ++dropped_;
  }
  batches_.push_back(message);
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
