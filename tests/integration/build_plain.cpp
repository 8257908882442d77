/// Builds fields of the project's own shapes with nothing but the code that makes and encodes a field, for processors that have no host tool.
///
///     build_plain GRID THREADS NAME...        GRID voxels along the longest side
///
/// Prints one line a shape: its name and the hash of its field, which is the same for any number of threads, compiler and processor.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>

#include "host/cloud/placement.h"
#include "host/cloud/shapes.h"
#include "host/encoding/write_image.h"
#include "host/field/build_field.h"
#include "host/field/make_grid.h"
#include "host/field/parallel.h"
#include "shared/field_view.h"

namespace {

using namespace isotouch;

constexpr std::size_t kPoints = 1000;

std::uint64_t hash_of(const cloud::Shape& shape, int voxels) {
  const cloud::OrientedPoints drawn = cloud::sample_shape(shape, kPoints);
  const cloud::Placement placement = cloud::place(drawn.positions, {std::nullopt, 70.0});
  const cloud::OrientedPoints points = cloud::placed(drawn, placement);
  Eigen::Vector3d low = points.positions.front(), high = low;
  for (const Eigen::Vector3d& p : points.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const field::Grid grid = field::make_grid(low, high, (high - low).maxCoeff() / voxels, field::field_margin(field::kBand));
  field::Progress quiet;
  const field_file::Image image = encoding::write_image(field::build_field(points, grid, field::kBand, quiet), {});
  return FieldView::parse(image.bytes())->hash();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "usage: build_plain GRID THREADS NAME...\n"), 2;
  try {
    field::threads_wanted = static_cast<unsigned>(std::atoi(argv[2]));
    for (const char* name : std::span(argv + 3, static_cast<std::size_t>(argc - 3))) {
      std::printf("%s %016llx\n", name, static_cast<unsigned long long>(hash_of(cloud::shape(name), std::atoi(argv[1]))));
    }
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "build_plain: %s\n", error.what()), 1;
  }
  return 0;
}
