#include "firmware/loop/memory_check.h"

#include "shared/hash64.h"

namespace isotouch::loop {

MemoryCheck::MemoryCheck(FieldSlots& fields, std::span<const std::uint8_t> model)
    : fields_(fields), model_(model), hash_(hash64(model.data(), model.size())) {}

Damage MemoryCheck::step() {
  if (const std::uint32_t damaged = fields_.damaged_in(part_); damaged != 0) damaged_ = damaged;
  part_ = (part_ + 1) % FieldSlots::kParts;
  if (hash64(model_.data(), model_.size()) != hash_) return Damage::kModel;
  return damaged_ != 0 && damaged_ == fields_.published().generation ? Damage::kField : Damage::kNone;
}

}  // namespace isotouch::loop
