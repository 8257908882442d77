/// The field that each tick of a recording felt: the one of its beginning, or what patches made of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/trace/recorded_patches.h"
#include "host/trace/trace_file.h"
#include "shared/field_view.h"
#include "shared/patch_chain.h"

namespace isotouch::trace {

class FeltField {
 public:
  /// given     the recording's first field, or one that its patches lead to; stays alive as long as this. A trace without outputs, or one that names no
  ///           field, may be of any
  /// fails     InputError: the trace was recorded on another field; its patches are not there or do not fit
  FeltField(const Trace& trace, const FieldView& given);
  FeltField(FeltField&&) = default;
  FeltField(const FeltField&) = delete;  // the patched images stand in its memory

  /// That of the next tick; all ticks come in order.
  ///
  /// returns   nullptr: the patches have not led to the given field yet
  /// fails     InputError: the tick takes a patch over that is not there
  const FieldView* next(const Input& input);
  /// That of the last tick.
  const FieldView* now() const { return before_ > 0 ? nullptr : &chain_.field(); }

 private:
  std::size_t before_ = 0;  ///< patches that lead to the given field and have not come yet
  std::optional<RecordedPatches> patches_;
  std::array<std::vector<std::uint64_t>, 2> memory_;  ///< of patched images
  PatchChain chain_;
};

}  // namespace isotouch::trace
