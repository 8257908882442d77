#include "host/encoding/inside_samples.h"

#include <algorithm>
#include <vector>

namespace isotouch::encoding {

using namespace image_layout;

std::size_t inside_samples(const FieldView& view) {
  const auto inside_brick = [&](std::uint32_t number) -> std::size_t {
    if (number <= kInside) return number == kInside ? kSamplesPerBrick : 0;
    const std::int16_t* brick = view.bricks + number * kSamplesPerBrick;
    return static_cast<std::size_t>(std::count_if(brick, brick + kSamplesPerBrick, [](std::int16_t c) { return c < 0; }));
  };
  const auto inside_node = [&](std::uint32_t number) -> std::size_t {
    if (number <= kInside) return number == kInside ? kBricksPerNode * kSamplesPerBrick : 0;
    const std::uint32_t* node = view.nodes + number * kBricksPerNode;
    std::size_t sum = 0;
    for (std::size_t n = 0; n < kBricksPerNode; ++n) sum += inside_brick(node[n]);
    return sum;
  };
  std::size_t sum = 0;
  const int cells = view.root_size[0] * view.root_size[1] * view.root_size[2];
  for (int cell = 0; cell < cells; ++cell) sum += inside_node(view.root[cell]);
  return sum;
}

}  // namespace isotouch::encoding
