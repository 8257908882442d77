/// Makes the recording of a patched field that every processor replays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <string>

#include "firmware/core/render.h"
#include "shared/trace.h"
#include "tests/firmware/core/led_hand.h"
#include "tests/support/field_patch.h"

namespace isotouch::core {
namespace {

/// How tests/golden/positions_patches and field_1_3 were made: into the folder that ISOTOUCH_GOLDEN_OUT names.
TEST(MovingSurface, DISABLED_WritesTheGoldenRecording) {
  const char* folder = std::getenv("ISOTOUCH_GOLDEN_OUT");
  ASSERT_NE(folder, nullptr);
  std::deque<FieldImage> fields;
  for (int n = 0; n <= 14; ++n) {
    const Point centre = {12 + 0.3 * n, 12, 11 + std::sin(0.8 * n)};
    fields.push_back(FieldImage({26, 24, 24},
                                [=](const Point& at) {
                                  return n == 9 ? 100.0 : length(at - centre) - 5 - 0.1 * n;  // once it is gone
                                },
                                {.edge_mm = 1.0,
                                 .band = 2.0,
                                 .stiffness = kStiffness,
                                 .origin_mm = {0, 0, 0},
                                 .prefilter = false,
                                 .interpolation = Interpolation::kTrilinear}));
  }
  const auto write = [&](const std::string& name, const auto& bytes) {
    std::ofstream file(std::string(folder) + "/" + name, std::ios::binary | std::ios::app);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  TraceHeader header;
  header.field_hash = fields[0].view().hash();
  header.has_outputs = true;
  header.record_count = 1000;
  header.settings.friction = Ratio::of(0.3);
  header.settings.hand_damping = Damping::of(0.001);
  write("field_1_3.itf", fields[0].bytes());
  write("positions_patches.trace", encode(header));
  const PositionModel model = make_position_model(header.device, header.settings, header.period_ns, fields[0].view());
  PositionState state;
  Chain chain(header);
  std::size_t now = 0;
  for (int t = 0; t < 1000; ++t) {
    Input in = position_input({mm(13 + 2 * std::sin(0.011 * t)), mm(12 + std::cos(0.017 * t)), mm(std::max(14.0, 21 - 0.03 * t))});
    if (t % 66 == 65 && now + 1 < fields.size()) {
      write("positions_patches.patches", test::make_patch(fields[now].view(), fields[now + 1].view()));
      ++now;
      in.requests = kRequestMoved;
      in.moved_to = static_cast<std::uint32_t>(fields[now].view().hash());
    }
    in.field_generation = static_cast<std::uint32_t>(now + 1);
    const Output out = render_position(in, fields[now].view(), model, state);
    write("positions_patches.trace", encode(TraceRecord{in, out, chain.extend(in, out), static_cast<std::uint64_t>(t) * 1'000'000}));
  }
}

}  // namespace
}  // namespace isotouch::core
