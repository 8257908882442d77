/// The part of a field that the tick reads now, looked at again after every tick: a bit that flips there is felt at once, and the check of the whole
/// field would need two seconds to find it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/loop/block_sums.h"
#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::loop {

class FeltBlocks {
 public:
  /// For another field.
  void forget() { now_ = {}; }

  /// Looks at all that a sample within two voxels of `point` reads, and at what the last call looked at, because the tick began there.
  ///
  /// field     a view that is whole itself; its image may be damaged
  /// point     index coordinates
  /// returns   whether all of it is as it was when the field was verified
  /// tick      yes: at most 80 blocks, some twenty mostly
  bool are_whole(const FieldView& field, const BlockSums& sums, const Vec3<Voxel>& point);

 private:
  /// Eight bricks, each in at most two blocks and with an entry in three tables.
  struct Blocks {
    std::array<std::size_t, 40> numbers{};
    std::size_t count = 0;
    bool has(std::size_t number) const;
  };

  bool look(const FieldView& field, const BlockSums& sums, const void* at, std::size_t bytes);

  Blocks now_, before_;
};

}  // namespace isotouch::loop
