/// The door for patches: one is refused, or gives the image that it names; what that is, the image's own door judges.
#include "host/field_file/make_patch.h"
#include "shared/crc32.h"
#include "shared/field_patch.h"
#include "shared/field_view.h"
#include "shared/hash64.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;
using namespace patch_layout;

namespace {

test::FieldImage ball(double radius) {
  return {{24, 20, 16},
          [=](const test::Point& at) {
            return length(at - test::Point{11, 10, 8}) - radius;
          },
          {.band = 2.0, .prefilter = false, .interpolation = Interpolation::kTrilinear}};
}

/// The field that every input is tried on.
const FieldView& before() {
  static const test::FieldImage image = ball(3.0);
  return image.view();
}

/// A good patch with some bytes changed: u16 place, u8 value.
std::vector<std::uint8_t> edited(fuzz::Front edits) {
  static const std::vector<std::uint8_t> good = field_file::make_patch(before(), ball(4.0).view());
  std::vector<std::uint8_t> bytes = good;
  while (!edits.empty()) {
    const std::size_t at = edits.take<std::uint16_t>() % bytes.size();
    bytes[at] = edits.take<std::uint8_t>();
  }
  return bytes;
}

void seal(std::vector<std::uint8_t>& bytes) {
  store_le(&bytes[kTotalBytesAt], std::uint64_t{bytes.size()});
  store_le(&bytes[kChecksumAt], crc32(&bytes[kTotalBytesAt], bytes.size() - kTotalBytesAt));
}

}  // namespace

/// data      a u8: bit 0 = the rest are edits of a good patch, else the patch itself; bit 1 = once applied, it names what it gave
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t says = data[0];
  std::vector<std::uint8_t> bytes = (says & 1) != 0 ? edited({data + 1, size - 1}) : std::vector<std::uint8_t>(data + 1, data + size);
  if (bytes.size() < kHeaderBytes) return 0;
  seal(bytes);
  Result<FieldPatch> patch = FieldPatch::parse(bytes);
  if (!patch || patch->image_bytes() > (1U << 24)) return 0;
  std::vector<std::uint64_t> words((patch->image_bytes() + 7) / 8);
  const std::span<std::uint8_t> image(reinterpret_cast<std::uint8_t*>(words.data()), patch->image_bytes());
  auto applied = apply(*patch, before(), image);
  if (!applied && applied.error() == Error::kBadChecksum && (says & 2) != 0) {  // a fuzzer finds no hash; a person who means harm does
    store_le(&bytes[kHashAfterAt], hash64(image.data(), image.size()));
    seal(bytes);
    patch = FieldPatch::parse(bytes);
    applied = apply(*patch, before(), image);
    fuzz::hold(applied.has_value(), "the image is the one that the patch now names");
  }
  if (!applied) return 0;
  fuzz::hold(hash64(image.data(), image.size()) == patch->hash_after, "the image is the one that the patch names");
  static_cast<void>(FieldView::parse(image));
  return 0;
}
