/// A queue of fixed length from one thread to one other. A full ring refuses; nobody ever waits.
///
/// tick      yes, either side: constant cost, no lock, no loop
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace isotouch::loop {

template <class T>
class Ring {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// size      entries, rounded up to a power of two; allocated and touched here and never again
  explicit Ring(std::size_t size) : places_(std::bit_ceil(size)), mask_(places_.size() - 1) {}

  std::size_t size() const { return places_.size(); }

  /// Writer's side. returns false: full, the value is not taken and counted as lost
  bool push(const T& value) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (is_full()) {
      lost_.store(lost_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    places_[end & mask_] = value;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// Writer's side: a `push` would be refused.
  bool is_full() const { return end_.load(std::memory_order_relaxed) - begin_.load(std::memory_order_acquire) == places_.size(); }

  /// Reader's side. returns false: empty
  bool pop(T& value) {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return false;
    value = places_[begin & mask_];
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

  /// Values refused since the beginning, modulo 2^32; any thread.
  std::uint32_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  std::vector<T> places_;
  std::size_t mask_;
  alignas(64) std::atomic<std::size_t> end_{0};
  std::atomic<std::uint32_t> lost_{0};
  alignas(64) std::atomic<std::size_t> begin_{0};
};

}  // namespace isotouch::loop
