#include "firmware/daemon/printer.h"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace isotouch::daemon {

struct Printer::Queue {
  std::mutex mutex;
  std::condition_variable changed;
  std::string waiting;
  std::uint64_t left_out = 0;  ///< texts, since `waiting` was full
  std::uint64_t progress = 0;  ///< counts what the thread has done
  bool is_ending = false, has_ended = false;

  void advance() {
    const std::lock_guard guard(mutex);
    ++progress;
    changed.notify_all();
  }

  /// What is to be written next, with a line for what was left out behind it.
  ///
  /// returns   false: everything is written, and nothing will follow
  bool take(std::string& text) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return !waiting.empty() || is_ending; });
    text.swap(waiting);
    waiting.clear();
    if (left_out > 0) text += std::to_string(left_out) + " messages were left out, because nobody read the output\n";
    left_out = 0;
    has_ended = text.empty();
    changed.notify_all();
    return !has_ended;
  }
};

namespace {

constexpr std::size_t kPiece = 4096;  // a pipe has room for so many or for none, so a slow reader is seen to read

/// returns   how many bytes need not be written any more; all of them where nobody can read any
std::size_t write_some(int descriptor, std::string_view text) {
  const ssize_t written = write(descriptor, text.data(), std::min(text.size(), kPiece));
  if (written >= 0) return static_cast<std::size_t>(written);
  if (errno == EINTR) return 0;
  if (errno != EAGAIN) return text.size();
  pollfd room{descriptor, POLLOUT, 0};  // another program has made it non-blocking
  poll(&room, 1, -1);
  return 0;
}

}  // namespace

Printer::Printer(int descriptor) : queue_(std::make_shared<Queue>()) {
  std::thread([descriptor, queue = queue_] {
    pthread_setname_np(pthread_self(), "print");
    for (std::string text; queue->take(text);) {
      for (std::size_t at = 0; at < text.size(); queue->advance()) at += write_some(descriptor, std::string_view(text).substr(at));
    }
  }).detach();
}

Printer::~Printer() {
  std::unique_lock lock(queue_->mutex);
  queue_->is_ending = true;
  queue_->changed.notify_all();
  for (bool moves = true; moves && !queue_->has_ended;) {
    const std::uint64_t before = queue_->progress;
    moves = queue_->changed.wait_for(lock, std::chrono::milliseconds(500), [&] { return queue_->has_ended || queue_->progress != before; });
  }
}

void Printer::say(std::string_view text) {
  const std::lock_guard guard(queue_->mutex);
  if (queue_->waiting.size() + text.size() + 1 > kRoom) {
    ++queue_->left_out;
    return;
  }
  queue_->waiting.append(text).append("\n");
  queue_->changed.notify_all();
}

}  // namespace isotouch::daemon
