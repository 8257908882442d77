#include "host/encoding/write_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "host/encoding/apron.h"
#include "host/encoding/brick_rows.h"
#include "host/encoding/brick_tree.h"
#include "host/encoding/certificate.h"
#include "host/encoding/lay_out_image.h"
#include "host/encoding/round_creases.h"
#include "host/encoding/spline.h"
#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::encoding {

namespace {

using namespace image_layout;

/// Samples beyond the grid in its last bricks are far outside; then tells whether the whole brick is one constant.
BrickKind finish(Coefficients& brick, const field::Brick& source, const Eigen::Vector3i& size, std::int16_t band) {
  const bool beyond = ((4 * source.cell).array() + 4 > size.array()).any();
  for (int n = 0; beyond && n < 64; ++n) {
    const Eigen::Vector3i sample = 4 * source.cell + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4);
    if ((sample.array() >= size.array()).any()) brick[static_cast<std::size_t>(n)] = band;
  }
  const auto all = [&](int value) { return std::all_of(brick.begin(), brick.end(), [=](std::int16_t c) { return c == value; }); };
  return all(band) ? BrickKind::kOutside : all(-band) ? BrickKind::kInside : BrickKind::kStored;
}

/// Each stored brick's stiffness in 255ths of the largest, and none for bricks 0 and 1.
std::vector<std::uint8_t> stiffness_table(const std::vector<double>& stiffness, const std::vector<std::size_t>& stored) {
  if (stiffness.empty()) return {};
  const double unit = *std::max_element(stiffness.begin(), stiffness.end()) / kFullStiffness;
  std::vector<std::uint8_t> table(2);
  for (const std::size_t b : stored) {
    table.push_back(static_cast<std::uint8_t>(std::clamp(std::floor(stiffness[b] / unit + 0.5), 1.0, double{kFullStiffness})));
  }
  return table;
}

}  // namespace

field_file::OpenField write_field(field::BandField field, FieldInfo info, SmallComponents* dropped) {
  if (info.method == Method::kPublished) info.interpolation = Interpolation::kTrilinear;
  ImageHeader header = image_header(field.grid, field.band, info);  // before the work: it refuses what does not fit

  const std::vector<Neighbours> around = neighbours(field);
  const field::BandField held =
      info.method == Method::kPublished ? std::move(field) : round_creases(std::move(field), around);  // what the grid can hold
  const int steps = info.interpolation == Interpolation::kSpline ? kSplineSteps : 0;
  std::vector<Coefficients> coefficients = spline_coefficients(held, around, steps);
  SmallComponents small;
  if (info.method != Method::kPublished) small = drop_small_components(coefficients, around);
  if (dropped != nullptr) *dropped = small;
  const auto band = static_cast<std::int16_t>(load_le<std::int32_t>(&header[kBandAt]));
  std::vector<BrickKind> kinds(coefficients.size());
  for (std::size_t b = 0; b < kinds.size(); ++b) kinds[b] = finish(coefficients[b], held.bricks[b], held.grid.size, band);
  store_certificate(certify(held, around, coefficients), header);
  const BrickTree tree = brick_tree(BrickRows(held), kinds);

  const std::vector<std::uint8_t> table = stiffness_table(held.stiffness, tree.stored);
  field_file::Image image = lay_out_image(header, {tree.root, tree.nodes, tree.stored.size(), table}, [&](std::uint8_t* at) {
    for (const std::size_t b : tree.stored)
      at = std::copy_n(reinterpret_cast<const std::uint8_t*>(&coefficients[b]), sizeof(Coefficients), at);
  });

  const Result<FieldView> view = FieldView::parse(image.bytes());
  if (!view) {  // the one thing that a field can still have wrong
    throw InputError(
        "the surface reaches the border of the grid, so it encloses no body; check the normals of the points, or the directions of the "
        "faces");
  }
  return {std::move(image), *view};
}

field_file::Image write_image(field::BandField field, FieldInfo info) { return write_field(std::move(field), info).image; }

FieldInfo info_of(const FieldView& view) {
  const std::uint8_t* at = view.image.data();
  const auto real = [at](std::size_t offset) { return std::bit_cast<double>(load_le<std::uint64_t>(at + offset)); };
  FieldInfo info;
  info.stiffness_n_per_mm = static_cast<double>(view.stiffness.raw()) / (1 << Stiffness::kFractionBits);
  info.source_hash = load_le<std::uint64_t>(at + kSourceHashAt);
  info.method = view.method;
  info.interpolation = view.interpolation;
  info.point_count = load_le<std::uint32_t>(at + kPointCountAt);
  info.placement = {real(kScaleAt), {real(kOffsetAt), real(kOffsetAt + 8), real(kOffsetAt + 16)}};
  return info;
}

}  // namespace isotouch::encoding
