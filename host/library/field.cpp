#include "host/library/field.h"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "host/field_file/image.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/library/call.h"
#include "host/to_double.h"
#include "host/trace/place_sample.h"
#include "host/trace/stated_placement.h"
#include "shared/bytes.h"
#include "shared/certificate.h"

using namespace isotouch;
using namespace isotouch::library;

namespace {

/// fails     InputError: what a controller would not let a hand touch either
std::uint64_t taken(field_file::StoredField stored, const std::string& name) {
  field_file::OpenField open = field_file::open_field(std::move(stored), name);
  const CertificateCheck check = check_certificate(open.view, assumed_loop(open.view), {});
  if (!check.accepted && check.error != Error::kTooStiff)  // which stiffness is felt, and with which device, a touch says
    throw InputError(name + ": not usable as a field: " + describe(check.error) + "; build it again");
  return add(std::make_unique<FieldThing>(std::move(open)));
}

isotouch_field_facts facts_of(const FieldView& view) {
  const std::uint8_t* const header = view.image.data();
  isotouch_field_facts facts{};
  facts.hash = view.hash();
  facts.image_bytes = view.image.size();
  facts.voxel_mm = to_double(view.edge);
  facts.band_mm = to_double(view.band) * facts.voxel_mm;
  facts.stiffness_n_mm = to_double(view.stiffness);
  facts.advised_stiffness_n_mm = to_double(Stiffness::from_raw(load_le<std::int32_t>(header + image_layout::kAdvisedStiffnessAt)));
  const auto placement = trace::stated_placement(view).value_or(trace::StatedPlacement{0, Eigen::Vector3d::Zero()});
  facts.scale = placement.scale;
  const Eigen::Vector3d origin = to_double(view.origin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    facts.low_mm[axis] = origin[static_cast<Eigen::Index>(axis)];
    facts.high_mm[axis] = facts.low_mm[axis] + facts.voxel_mm * (view.size[axis] - 1);
    facts.offset_mm[axis] = placement.offset[static_cast<Eigen::Index>(axis)];
    facts.samples[axis] = static_cast<std::uint32_t>(view.size[axis]);
  }
  facts.interpolation = static_cast<std::uint32_t>(view.interpolation);
  facts.is_published = view.method == Method::kPublished ? 1 : 0;
  facts.varies_in_stiffness = view.stiffness_parts != nullptr ? 1 : 0;
  return facts;
}

}  // namespace

isotouch_status isotouch_field_load(const char* path, isotouch_field* field) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const std::string name = file_name(path);
    required(field, "field");
    *field = taken(field_file::read_field(read_file(name), name), name);
  });
}

isotouch_status isotouch_field_read(const void* bytes, size_t size, isotouch_field* field) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const auto* const first = static_cast<const std::uint8_t*>(required(bytes, "bytes"));
    required(field, "field");
    require_count(size, 1, "bytes");
    const std::string name = "these bytes";
    *field = taken(field_file::read_field(std::vector<std::uint8_t>(first, first + size), name), name);
  });
}

isotouch_status isotouch_field_save(isotouch_field field, const char* path) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const std::string name = file_name(path);
    const Held held(field, Kind::kField, Use::kShared);
    const field_file::OpenField& open = *held.as<FieldThing>().open;
    const std::vector<std::uint8_t> packed = field_file::pack(open.view, open.invented);
    write_file(name, packed.data(), packed.size());
  });
}

isotouch_status isotouch_field_describe(isotouch_field field, isotouch_field_facts* facts, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(facts, "facts", size, "isotouch_field_facts");
    const Held held(field, Kind::kField, Use::kShared);
    *facts = facts_of(held.as<FieldThing>().open->view);
  });
}

isotouch_status isotouch_field_sample(isotouch_field field, size_t count, const double* points_mm, double* distance_mm, double* gradient,
                                      double* stiffness, uint8_t* in_band) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const Held held(field, Kind::kField, Use::kShared);
    if (count == 0) return;
    require_count(count, 3 * sizeof(double), "points");
    require_finite(required(points_mm, "points_mm"), 3 * count, "points_mm");
    const FieldView& view = held.as<FieldThing>().open->view;
    for (std::size_t i = 0; i < count; ++i) {
      const double* const at = points_mm + 3 * i;
      const trace::PlaceSample sample = trace::sample_place(view, {at[0], at[1], at[2]});
      if (distance_mm != nullptr) distance_mm[i] = sample.distance_mm;
      if (gradient != nullptr) Eigen::Map<Eigen::Vector3d>(gradient + 3 * i) = sample.gradient;
      if (stiffness != nullptr) stiffness[i] = sample.stiffness_n_mm;
      if (in_band != nullptr) in_band[i] = sample.in_band ? 1 : 0;
    }
  });
}
