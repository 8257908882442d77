/// Numbers for things: whoever holds a number that was freed gets an error, and never somebody else's memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "host/library/call.h"

namespace isotouch::library {

/// What a handle may stand for.
enum class Kind : std::uint8_t { kField = 1, kTouch, kTrace, kController };

struct Thing {
  explicit Thing(Kind of) : kind(of) {}
  virtual ~Thing() = default;
  Thing(const Thing&) = delete;
  Thing& operator=(const Thing&) = delete;
  const Kind kind;
};

/// How a call uses a thing.
enum class Use : std::uint8_t { kShared, kAlone };

/// One place for a thing. A call that uses it counts itself in `users` first and looks at `id` then; whoever frees it must be alone.
struct Slot {
  std::atomic<std::uint64_t> id{0};    ///< 0 = empty
  std::atomic<std::int32_t> users{0};  ///< -1 = one that is alone
  std::unique_ptr<Thing> thing;        ///< changed only by whoever is alone
};

/// Gives a thing its number.
///
/// fails     CallError: no number is left
std::uint64_t add(std::unique_ptr<Thing> thing);

/// Frees it. 0 is none. fails CallError
void remove(std::uint64_t handle);

/// Holds a thing for the time of a call.
///
/// real time   construction and end allocate nothing and wait for nothing, unless it fails
class Held {
 public:
  /// fails     CallError: the handle is none of this kind, or is busy
  Held(std::uint64_t handle, Kind kind, Use use);
  ~Held();
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  template <class T>
  T& as() const {
    return static_cast<T&>(*slot_.thing);
  }

 private:
  Slot& slot_;
  Use use_;
};

}  // namespace isotouch::library
