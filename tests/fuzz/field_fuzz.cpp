/// The door for fields: what `parse` takes may be felt anywhere without leaving the image.
#include "firmware/core/render.h"
#include "shared/crc32.h"
#include "shared/field_view.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < image_layout::kHeaderBytes) return 0;
  fuzz::Copy copy(data, size);
  const auto image = copy.bytes();
  // A fuzzer finds no checksum; a person who means harm does.
  store_le(image.data() + image_layout::kChecksumAt,
           crc32(image.data() + image_layout::kTotalBytesAt, image.size() - image_layout::kTotalBytesAt));
  const Result<FieldView> field = FieldView::parse(image);
  if (!field) return 0;

  TickSettings settings;
  settings.friction = Ratio::of(0.3);
  settings.hand_damping = Damping::of(0.002);
  const core::PositionModel model = core::make_position_model(libnifalcon_model(), settings, 1'000'000, *field);
  core::PositionState state;
  std::uint64_t mixed = field->hash();
  for (int tick = 0; tick < 64; ++tick) {  // everywhere in and around the grid, the fuzzer's bytes decide where
    const auto along = [&](int axis) {
      mixed = mixed * 6364136223846793005U + 1442695040888963407U;
      const std::int64_t reach = std::int64_t{field->size[static_cast<std::size_t>(axis)]} * field->edge.raw();
      const auto origin = axis == 0 ? field->origin.x : axis == 1 ? field->origin.y : field->origin.z;
      return Mm::from_raw(saturate32(origin.raw() + static_cast<std::int64_t>(mixed >> 33) % (2 * reach + 1) - reach / 2));
    };
    const Output out = core::render_position(position_input({along(0), along(1), along(2)}), *field, model, state);
    fuzz::hold((out.status & kContact) != 0 || out.force == Vec3<Newton>{}, "no contact gives no force");
  }
  return 0;
}
