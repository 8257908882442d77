#include "host/commands/field_bench.h"

#include <algorithm>
#include <array>

#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/commands/built_field.h"
#include "host/files/temporary_folder.h"

namespace isotouch::commands {

namespace {

double seconds_of(BuildOptions options, BuildMethod method) {
  options.method = method;
  return built_field(options).report.seconds;
}

}  // namespace

std::vector<FieldTimes> time_fields(ProgressBar& bar) {
  const TemporaryFolder folder;
  std::vector<FieldTimes> all;
  for (const char* name : {"hydrant", "owl", "boy", "bomberman", "jaguar"}) {
    bar.begin(name);
    const cloud::Shape shape = cloud::shape(name);
    BuildOptions options;
    options.quiet = true;
    options.input = folder.path / (shape.name + ".ply");
    options.out = folder.path / (shape.name + ".itf");
    cloud::write_ply(options.input, cloud::sample_shape(shape, shape.default_points), "isotouch bench field");

    std::array<double, kFieldRuns> runs;
    for (double& run : runs) run = seconds_of(options, BuildMethod::kDefault);
    std::nth_element(runs.begin(), runs.begin() + kFieldRuns / 2, runs.end());
    all.push_back({shape.name, shape.default_points, runs[kFieldRuns / 2], seconds_of(options, BuildMethod::kPublished)});
  }
  return all;
}

}  // namespace isotouch::commands
