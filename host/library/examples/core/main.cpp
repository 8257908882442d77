/// The core inside a program of one's own, without libisotouch, allocation or floating point: a hand sinks into a field that is an image in memory.
///
///     core IMAGE        made by `isotouch export FIELD -o IMAGE.itfi`
#include <cstdint>
#include <cstdio>
#include <span>

#include "firmware/core/render.h"
#include "shared/field_view.h"
#include "shared/trace.h"

namespace {

alignas(8) std::uint8_t image[16 << 20];  // as a board keeps it

}  // namespace

int main(int argc, char** argv) {
  using namespace isotouch;
  std::FILE* const file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "usage: core IMAGE\n");
    return 2;
  }
  const std::size_t size = std::fread(image, 1, sizeof image, file);
  std::fclose(file);
  const Result<FieldView> field = FieldView::parse({image, size});
  if (!field) {
    std::fprintf(stderr, "core: %s: %s\n", argv[1], describe(field.error()));
    return 1;
  }

  TraceHeader header;
  header.has_outputs = true;
  const core::PositionModel model = core::make_position_model(header.device, header.settings, header.period_ns, *field);
  core::PositionState state;
  Chain chain(header);
  int touching = 0;
  constexpr std::int32_t kTicks = 1000, kWay = 40 << Mm::kFractionBits;
  for (std::int32_t tick = 0; tick < kTicks; ++tick) {
    const Input input = position_input({Mm{}, Mm::from_raw(kWay - kWay / kTicks * tick), Mm{}});
    const Output output = core::render_position(input, *field, model, state);
    touching += (output.status & kContact) != 0 ? 1 : 0;
    chain.extend(input, output);
  }
  std::printf("%d ticks, %d in contact, replay hash %016llx\n", int{kTicks}, touching, static_cast<unsigned long long>(chain.value()));
  return touching > 0 ? 0 : 1;
}
