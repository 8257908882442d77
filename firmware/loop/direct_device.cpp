#include "firmware/loop/direct_device.h"

namespace isotouch::loop {

Wake DirectDevice::wait(std::int64_t /*until_ns*/) {
  FalconPacket packet{};
  const std::int64_t sent = clock_.now_ns();
  Answer answer = Answer::kAbsent;
  while (answer == Answer::kAbsent) {
    if (stop_.load(std::memory_order_relaxed)) return Wake::kEnd;
    FalconCommand command = command_.falcon;
    if (guard_ != nullptr) command.words = guard_->pass(command_, sent);
    answer = port_.exchange(command, packet);
    word_delay_.handed_over(command_, sent, answer);
  }
  if (answer == Answer::kEnd) return Wake::kEnd;
  clock_.sleep_until_ns(sent + period_ns_);
  if (answer == Answer::kSilent) return Wake::kDue;
  if (guard_ != nullptr) guard_->hear(packet, clock_.now_ns());
  sample_ = {packet, sample_.number + 1, sent, clock_.now_ns(), word_delay_.take()};
  return Wake::kReply;
}

}  // namespace isotouch::loop
