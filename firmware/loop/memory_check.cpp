#include "firmware/loop/memory_check.h"

#include "shared/hash64.h"

namespace isotouch::loop {

MemoryCheck::MemoryCheck(FieldSlots& fields, const Prepared& prepared) : fields_(fields), prepared_(prepared), hash_(hash_of_prepared()) {}

Damage MemoryCheck::step() {
  if (const std::uint32_t damaged = fields_.damaged_in(part_); damaged != 0) damaged_ = damaged;
  part_ = (part_ + 1) % FieldSlots::kParts;
  is_prepared_damaged_ |= hash_of_prepared() != hash_;
  if (is_prepared_damaged_) return Damage::kPrepared;
  return damaged_ != 0 && damaged_ == fields_.published_generation() ? Damage::kField : Damage::kNone;
}

std::uint64_t MemoryCheck::hash_of_prepared() const {
  std::uint64_t hash = 0;
  for (const std::span<const std::uint8_t> bytes : prepared_) hash = hash64(bytes.data(), bytes.size(), hash);
  return hash;
}

}  // namespace isotouch::loop
