#include "host/library/handles.h"

#include <array>
#include <mutex>
#include <string>
#include <utility>

namespace isotouch::library {

namespace {

// A handle: 8 bits of kind, 40 bits that no other handle of this place has, 16 bits of place + 1.
constexpr std::size_t kPlaces = 4096;
constexpr int kPlaceBits = 16, kKindAt = 56;
constexpr std::uint64_t kPlaceMask = (1U << kPlaceBits) - 1;

struct Table {
  std::array<Slot, kPlaces> slots;
  std::mutex adding;
  std::uint64_t given = 0;
};

/// Never destroyed: a thread may still use it while the process ends.
Table& table() {
  static Table& only = *new Table;
  return only;
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::kField: return "field";
    case Kind::kTouch: return "touch";
    case Kind::kTrace: return "trace";
    case Kind::kController: return "controller";
  }
  return "thing";
}

/// fails     CallError: no handle looks like this
Slot& slot_of(std::uint64_t handle) {
  const std::uint64_t place = handle & kPlaceMask;
  if (handle == 0) refuse(ISOTOUCH_BAD_HANDLE, "the handle is 0, which is none; pass one that a function of this library has given out");
  if (place == 0 || place > kPlaces) refuse(ISOTOUCH_BAD_HANDLE, "this is no handle that this library has given out");
  return table().slots[static_cast<std::size_t>(place - 1)];
}

/// returns   false: somebody else is in the way
bool enter(Slot& slot, Use use) {
  std::int32_t users = 0;
  if (use == Use::kAlone) return slot.users.compare_exchange_strong(users, -1, std::memory_order_acquire);
  users = slot.users.load(std::memory_order_relaxed);
  while (users >= 0) {
    if (slot.users.compare_exchange_weak(users, users + 1, std::memory_order_acquire)) return true;
  }
  return false;
}

void leave(Slot& slot, Use use) {
  if (use == Use::kAlone) {
    slot.users.store(0, std::memory_order_release);
  } else {
    slot.users.fetch_sub(1, std::memory_order_release);
  }
}

/// Of a handle that its slot does not have.
[[noreturn]] void refuse_stranger() {
  refuse(ISOTOUCH_BAD_HANDLE, "the handle was freed, or this library has never given it out; make a new one");
}

}  // namespace

std::uint64_t add(std::unique_ptr<Thing> thing) {
  Table& all = table();
  const std::scoped_lock lock(all.adding);
  for (std::size_t place = 0; place < kPlaces; ++place) {
    Slot& slot = all.slots[place];
    if (slot.id.load(std::memory_order_relaxed) != 0 || !enter(slot, Use::kAlone)) continue;
    const std::uint64_t kind = static_cast<std::uint64_t>(thing->kind) << kKindAt;
    const std::uint64_t number = (++all.given << kPlaceBits) & ((std::uint64_t{1} << kKindAt) - 1);
    const std::uint64_t id = kind | number | (place + 1);
    slot.thing = std::move(thing);
    slot.id.store(id, std::memory_order_release);
    leave(slot, Use::kAlone);
    return id;
  }
  std::string sentence = "there are ";  // in pieces: gcc 12 sees an overlap in a sum of them (its bug 105651)
  sentence.append(std::to_string(kPlaces)).append(" handles already; free those that are not needed");
  refuse(ISOTOUCH_NO_MEMORY, sentence);
}

void remove(std::uint64_t handle) {
  if (handle == 0) return;
  Slot& slot = slot_of(handle);
  if (slot.id.load(std::memory_order_acquire) != handle) refuse_stranger();
  if (!enter(slot, Use::kAlone)) refuse(ISOTOUCH_BUSY, "another thread is using this; free it when that call has returned");
  std::unique_ptr<Thing> thing;
  const bool there = slot.id.load(std::memory_order_relaxed) == handle;
  if (there) {
    slot.id.store(0, std::memory_order_relaxed);
    thing = std::move(slot.thing);
  }
  leave(slot, Use::kAlone);
  if (!there) refuse_stranger();
}

Held::Held(std::uint64_t handle, Kind kind, Use use) : slot_(slot_of(handle)), use_(use) {
  if (slot_.id.load(std::memory_order_acquire) != handle) refuse_stranger();
  if (handle >> kKindAt != static_cast<std::uint64_t>(kind))
    refuse(ISOTOUCH_BAD_HANDLE, "this is the handle of a " + std::string(name_of(static_cast<Kind>(handle >> kKindAt))) +
                                    ", and that of a " + name_of(kind) + " is needed");
  if (!enter(slot_, use_))
    refuse(ISOTOUCH_BUSY, "another thread is using this " + std::string(name_of(kind)) + "; give each thread its own");
  if (slot_.id.load(std::memory_order_relaxed) == handle) return;
  leave(slot_, use_);
  refuse_stranger();
}

Held::~Held() { leave(slot_, use_); }

}  // namespace isotouch::library

isotouch_status isotouch_free(uint64_t handle) {
  return isotouch::library::guarded(ISOTOUCH_BAD_HANDLE, [&] { isotouch::library::remove(handle); });
}
