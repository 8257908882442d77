#include "host/trace/felt_field.h"

#include <span>
#include <string>

#include "host/error.h"
#include "host/trace/hash_text.h"

namespace isotouch::trace {

namespace {

/// How many of its patches lead from the recording's first field to this one.
///
/// fails     InputError: none does
std::size_t patches_to(const Trace& trace, const FieldView& given) {
  const std::uint64_t named = trace.header().field_hash, hash = given.hash();
  if (!trace.header().has_outputs || named == 0 || named == hash) return 0;
  const std::vector<std::uint8_t> bytes = patch_bytes(trace).value_or(std::vector<std::uint8_t>());
  std::span<const std::uint8_t> left = bytes;
  for (std::size_t count = 1; const auto patch = first_patch(left); ++count) {
    if (patch->hash_after == hash) return count;
    left = left.subspan(patch->patch_bytes());
  }
  throw InputError(trace.path() + ": " + describe(Error::kWrongField) + ", " + hash_text(named) +
                   "; give that field, or first render this hand on yours: isotouch replay FIELD TRACE -o OTHER.trace");
}

}  // namespace

FeltField::FeltField(const Trace& trace, const FieldView& given)
    : before_(patches_to(trace, given)),
      patches_(read_patches(trace, given, before_)),
      memory_(patches_ ? patches_->memory() : std::array<std::vector<std::uint64_t>, 2>{}),
      chain_(given, patches_ ? std::span<const std::uint8_t>(patches_->bytes) : std::span<const std::uint8_t>{}, places(memory_)) {}

const FieldView* FeltField::next(const Input& input) {
  if ((input.requests & kRequestMoved) != 0) {
    if (before_ > 0) {
      --before_;
    } else {
      require_patch(chain_.advance(input.moved_to));
    }
  }
  return now();
}

}  // namespace isotouch::trace
