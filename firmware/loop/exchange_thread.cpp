#include "firmware/loop/exchange_thread.h"

#include <algorithm>

#include "firmware/loop/word_delay.h"

namespace isotouch::loop {

Wake ExchangeThread::wait(std::int64_t until_ns) {
  for (;;) {
    const std::uint32_t heard = replies_.count();
    if (samples_.get().number != taken_) return Wake::kReply;
    if (ended_.load(std::memory_order_acquire)) return Wake::kEnd;
    if (clock_.now_ns() >= until_ns) return Wake::kDue;
    replies_.wait(heard, until_ns);
  }
}

Sample ExchangeThread::newest() {
  const Sample& sample = samples_.get();
  taken_ = sample.number;
  return sample;
}

void ExchangeThread::leave(const Command& command) {
  commands_.put(command);
  words_.ring();
}

void ExchangeThread::serve(const std::atomic<bool>& stop) {
  Sample sample;
  WordDelay word_delay;
  std::uint64_t tick = 0;
  std::int64_t ticked_ns = clock_.now_ns();
  while (!stop.load(std::memory_order_relaxed)) {
    Command command = commands_.get();
    FalconPacket packet{};
    const std::int64_t now = clock_.now_ns();
    if (command.tick != tick) ticked_ns = now;
    tick = command.tick;
    const std::int64_t silent_from = ticked_ns + silent_ns_;
    if (now >= silent_from) command.falcon.words = {};  // whoever should answer for them is not there
    if (guard_ != nullptr) command.falcon.words = guard_->pass(command, now);
    const std::int64_t sent = clock_.now_ns();
    const Answer answer = port_.exchange(command.falcon, packet);
    if (answer == Answer::kEnd) break;
    if (command.sample == sample.number) word_delay.handed_over(command, sent, answer);
    if (answer != Answer::kReply) continue;
    sample = {packet, sample.number + 1, sent, clock_.now_ns(), word_delay.take()};
    samples_.put(sample);
    replies_.ring();
    if (guard_ != nullptr) guard_->hear(packet, sample.arrival_ns);  // while the tick works
    await_words(sample, now < silent_from ? silent_from : kNever);
  }
  port_.rest();
  ended_.store(true, std::memory_order_release);
  replies_.ring();
}

/// Until the tick has answered this sample, at the latest until the next packet is due: to refresh the commands, or to take them away.
void ExchangeThread::await_words(const Sample& sample, std::int64_t silent_from) {
  const std::int64_t until = std::min(sample.sent_ns + refresh_ns_, silent_from);
  for (;;) {
    const std::uint32_t heard = words_.count();
    if (commands_.get().sample >= sample.number || clock_.now_ns() >= until) return;
    words_.wait(heard, until);
  }
}

}  // namespace isotouch::loop
