/// Passes the newest value from one thread to another. Neither side ever waits: of three places each side owns one, and an atomic exchange passes the
/// third.
///
/// tick      yes, either side: constant cost, no lock, no loop
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace isotouch::loop {

template <class T>
class Latest {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Before the first `put` the reader gets a default value.
  Latest() = default;
  Latest(const Latest&) = delete;
  Latest& operator=(const Latest&) = delete;

  /// Writer's side. Replaces what was there, read or not.
  void put(const T& value) {
    places_[writer_] = value;
    writer_ = between_.exchange(static_cast<std::uint8_t>(writer_ | kNew), std::memory_order_acq_rel) & kIndex;
  }

  /// Reader's side. The newest value; valid until the reader's next `get`.
  const T& get() {
    if ((between_.load(std::memory_order_relaxed) & kNew) != 0) reader_ = between_.exchange(reader_, std::memory_order_acq_rel) & kIndex;
    return places_[reader_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kNew = 4;

  std::array<T, 3> places_{};
  std::uint8_t writer_ = 0;
  alignas(64) std::uint8_t reader_ = 1;
  alignas(64) std::atomic<std::uint8_t> between_{2};
};

}  // namespace isotouch::loop
