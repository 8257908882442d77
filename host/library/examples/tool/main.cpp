/// A tool sinks from above into an object and feels its field.
///
///     tool FIELD
#include <algorithm>
#include <cstdio>
#include <exception>

#include "tool.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: tool FIELD\n");
    return 2;
  }
  try {
    isotouch_settings settings{};
    isotouch_settings_default(&settings, sizeof settings);
    settings.friction = 0.2;
    FieldAlgorithm algorithm(argv[1], settings);

    const isotouch_field_facts& object = algorithm.object();
    const double middle[3] = {(object.low_mm[0] + object.high_mm[0]) / 2, (object.low_mm[1] + object.high_mm[1]) / 2,
                              (object.low_mm[2] + object.high_mm[2]) / 2};
    const double above[3] = {middle[0], object.high_mm[1], middle[2]};
    const cVector3d from = FieldAlgorithm::toTool(above, 0.001), to = FieldAlgorithm::toTool(middle, 0.001);

    constexpr int kTicks = 1000;
    int tick = 0, touching = 0;
    double upwards = 0, largest = 0;
    Tool tool({[&] { return cVector3d(from.x(), from.y(), from.z() + (to.z() - from.z()) * tick / kTicks); },
               [&](const cVector3d& force) { upwards = force.z(), largest = std::max(largest, force.length()); }},
              algorithm);
    for (; tick < kTicks; ++tick) {
      tool.updateFromDevice();
      tool.computeInteractionForces();
      tool.applyToDevice();
      touching += algorithm.isInContact() ? 1 : 0;
    }
    std::printf("%d ticks, %d in contact, largest force %.3f N, at the end %.3f N upwards and the proxy %.2f mm above the tool\n", kTicks,
                touching, largest, upwards, algorithm.penetration() * 1000);
    return touching > 0 && upwards > 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tool: %s\n", error.what());
    return 1;
  }
}
