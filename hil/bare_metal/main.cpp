/// The core on a bare processor: hil/plain_replay.h on a field, a trace and its patches that stand in memory before the machine starts (`boot`).
///
/// Prints {"ticks", "hash", "first_difference"} as replay_plain does. Ends with 0 equal to what was recorded, 1 bad input, 3 different.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hil/bare_metal/semihosting.h"
#include "hil/plain_replay.h"
#include "shared/field_view.h"
#include "shared/patch_chain.h"

extern "C" {
// Places that board.ld names: the field stands first, then the trace, then the patches of the trace, each at the next multiple of 64.
extern const std::uint8_t files[];
extern const std::uint32_t file_sizes[];  // field, trace and patches, bytes
}

namespace {

using namespace isotouch;
using semihosting::write;

void write_number(std::uint64_t number, unsigned base, int least_digits) {
  char text[24];
  char* at = text + sizeof text;
  *--at = 0;
  for (int digit = 0; digit < least_digits || number != 0; ++digit, number /= base) *--at = "0123456789abcdef"[number % base];
  write(at);
}

alignas(8) std::array<std::array<std::uint8_t, 1 << 20>, 2> places;  // of images that patches lead to

int refuse(const char* file, Error why) {
  write(file);
  write(": ");
  write(describe(why));
  write("\n");
  return 1;
}

}  // namespace

int main() {
  const std::span<const std::uint8_t> image(files, file_sizes[0]);
  const std::span<const std::uint8_t> trace(files + image_layout::align64(std::size_t{file_sizes[0]}), file_sizes[1]);
  const Result<FieldView> field = FieldView::parse(image);
  if (!field) return refuse("field", field.error());
  const std::span<const std::uint8_t> patches(trace.data() + image_layout::align64(trace.size()), file_sizes[2]);
  const Result<Patches> checked = check_patches(patches, *field);
  if (!checked) return refuse("patches", checked.error());
  if (checked->largest_image > places[0].size()) return refuse("patches", Error::kBadSize);
  const Result<replay::Report> report = replay::run(*field, trace, {patches, {places[0], places[1]}});
  if (!report) return refuse("trace", report.error());
  write("{\"ticks\": ");
  write_number(report->ticks, 10, 1);
  write(", \"hash\": \"");
  write_number(report->hash, 16, 16);
  write("\", \"first_difference\": ");
  if (report->equal) {
    write("null");
  } else {
    write_number(report->first_difference, 10, 1);
  }
  write("}\n");
  return report->equal ? 0 : 3;
}
