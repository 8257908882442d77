/// Builds fields of the project's own shapes with nothing but the code that makes and encodes a field, for processors that have no host tool.
///
///     build_plain GRID THREADS NAME[:DIRT]...        GRID voxels along the longest side; DIRT front noise tilt flipped strays or bare
///
/// Prints one line a shape: its name and the hash of its field, which is the same for any number of threads, compiler and processor.
#include <Eigen/Core>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>
#include <string>
#include <utility>

#include "host/cloud/placement.h"
#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/encoding/write_image.h"
#include "host/field/parallel.h"
#include "host/field/scan_field.h"
#include "shared/field_view.h"

namespace {

using namespace isotouch;

constexpr std::size_t kPoints = 1000;

/// Every kind of work that `sound_scan` does, for the fields must be the same after it, too.
void spoil(cloud::OrientedPoints& points, const std::string& dirt) {
  cloud::Random random(6);
  if (dirt == "front") {
    cloud::OrientedPoints seen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.normals[i].z() < 0.2) continue;
      seen.positions.push_back(points.positions[i]);
      seen.normals.push_back(points.normals[i]);
    }
    points = seen;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3d off;
    for (double& x : off) x = random.uniform(-1, 1);  // arguments of one call would come in the compiler's order
    if (dirt == "noise") points.positions[i] += 2.0 * off;
    if (dirt == "tilt") points.normals[i] = (points.normals[i] + 0.6 * off).normalized();
    if (dirt == "flipped" && random.uniform() < 0.3) points.normals[i] = -points.normals[i];
    if (dirt == "strays" && random.uniform() < 0.1) points.positions[i] += 60.0 * off;
    if (dirt == "bare") points.normals[i].setZero();
  }
}

/// name      of a shape, with :DIRT behind it where it is to be spoilt
std::uint64_t hash_of(const std::string& name, int voxels) {
  const std::size_t colon = name.find(':');
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape(name.substr(0, colon)), kPoints);
  if (colon != std::string::npos) spoil(points, name.substr(colon + 1));
  field::SoundScan scan = field::sound_scan(std::move(points), {.estimate = name.ends_with(":bare")});
  scan.place(cloud::place(std::span(scan.points.positions).first(scan.measured), {std::nullopt, 70.0}));
  field::Progress quiet;
  const field::ScanField built = field::scan_field(scan, 70.0 / voxels, field::kBand, quiet);
  const field_file::Image image = encoding::write_image(built.field, {});
  return FieldView::parse(image.bytes())->hash();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "usage: build_plain GRID THREADS NAME...\n"), 2;
  try {
    const field::ThreadLimit limit(static_cast<unsigned>(std::atoi(argv[2])));
    for (const char* name : std::span(argv + 3, static_cast<std::size_t>(argc - 3))) {
      std::printf("%s %016llx\n", name, static_cast<unsigned long long>(hash_of(name, std::atoi(argv[1]))));
    }
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "build_plain: %s\n", error.what()), 1;
  }
  return 0;
}
