/// Hashes the memory that the tick relies on again, in small steps: the field that is felt, and what was prepared before the first tick. Neither may change
/// while it is used, so a difference is a flipped bit or a stray write. For a thread beside the tick; what the tick uses right now, the loop looks at itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/loop/field_slots.h"

namespace isotouch::loop {

enum class Damage : std::uint8_t {
  kNone,
  kState,     ///< what the tick remembers: it begins anew, and all is well again
  kField,     ///< until another field is published
  kPrepared,  ///< model, limits or settings, for good
};

class MemoryCheck {
 public:
  /// Bytes that do not change: those of the tick, and those of the guard.
  using Prepared = std::array<std::span<const std::uint8_t>, 2>;

  /// fields, prepared   live longer
  MemoryCheck(FieldSlots& fields, const Prepared& prepared);

  /// Hashes what was prepared, some kilobytes, and one of FieldSlots::kParts of the field. All is looked at within kParts steps.
  ///
  /// returns   the graver of what was found until now
  /// tick      no
  Damage step();

 private:
  std::uint64_t hash_of_prepared() const;

  FieldSlots& fields_;
  Prepared prepared_;
  std::uint64_t hash_;
  std::size_t part_ = 0;
  std::uint32_t damaged_ = 0;  ///< generation of a field in which something differed; 0 = none
  bool is_prepared_damaged_ = false;
};

}  // namespace isotouch::loop
