#include "host/field_file/described_field.h"

#include <utility>

#include "host/field_file/packed.h"
#include "shared/bytes.h"
#include "shared/packed_field.h"

namespace isotouch::field_file {

namespace {

bool has_stiffness_table(const PackedField& packed) {
  return load_le<std::uint32_t>(packed.image_header.data() + image_layout::kStiffnessTableAt) != 0;
}

/// Of a header that was checked.
FieldView header_of(std::span<const std::uint8_t> header, std::uint64_t image_bytes) {
  FieldView view = *FieldView::of_header(header, image_bytes);
  view.image = header;
  return view;
}

}  // namespace

DescribedField describe_field(const std::vector<std::uint8_t>& bytes, const std::string& name, bool whole) {
  const bool is_packed = PackedField::has_magic(bytes);
  if (is_packed && !whole) {
    const PackedField packed = checked_packed(bytes, name);
    if (packed.marks.empty() && !has_stiffness_table(packed))
      return {static_cast<std::size_t>(packed.image_bytes), bytes.size(), packed.image_hash,
              header_of(packed.image_header, packed.image_bytes)};
  }
  OpenField open = open_field(read_field(bytes, name), name);
  const std::size_t packed_bytes = is_packed ? bytes.size() : pack(open.view).size();
  const FieldView header = header_of(open.view.image.first(image_layout::kHeaderBytes), open.view.image.size());
  return {open.view.image.size(), packed_bytes, open.view.hash(), header, std::move(open)};
}

}  // namespace isotouch::field_file
