/// Reads the memory that the tick relies on again, in small steps: the field that is felt and the prepared model. Neither may change while it is used, so a
/// difference is a flipped bit or a stray write. For a thread beside the tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/loop/field_slots.h"

namespace isotouch::loop {

enum class Damage : std::uint8_t {
  kNone,
  kField,  ///< until another field is published
  kModel,  ///< device, limits or settings, for good
};

class MemoryCheck {
 public:
  /// fields    live longer
  /// model     bytes that do not change from here on; live longer
  MemoryCheck(FieldSlots& fields, std::span<const std::uint8_t> model);

  /// Looks at the model and at one of FieldSlots::kParts of the field. Takes up to a millisecond.
  ///
  /// tick      no
  Damage step();

 private:
  FieldSlots& fields_;
  std::span<const std::uint8_t> model_;
  std::uint64_t hash_;
  std::size_t part_ = 0;
  std::uint32_t damaged_ = 0;  ///< generation of a field in which something differed; 0 = none
};

}  // namespace isotouch::loop
