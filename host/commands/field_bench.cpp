#include "host/commands/field_bench.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/commands/build_blob.h"
#include "host/error.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

/// A folder that goes with its owner.
struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() / ("isotouch-bench-" + std::to_string(::getpid()));

  TemporaryFolder() {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw InputError(path.string() + ": cannot be made: " + error.message() + "; set TMPDIR to a folder that can be written");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

double seconds_of(BuildOptions options, blob::Method method) {
  options.method = method;
  return build_blob(options).report.seconds;
}

}  // namespace

std::vector<FieldTimes> time_fields() {
  const TemporaryFolder folder;
  std::vector<FieldTimes> all;
  for (const char* name : {"hydrant", "owl", "boy", "bomberman", "jaguar"}) {
    const cloud::Shape shape = cloud::shape(name);
    BuildOptions options;
    options.input = folder.path / (shape.name + ".ply");
    options.out = folder.path / (shape.name + ".itf");
    cloud::write_ply(options.input, cloud::sample_shape(shape, shape.default_points), "isotouch bench field");

    std::array<double, kFieldRuns> runs;
    for (double& run : runs) run = seconds_of(options, blob::Method::kDefault);
    std::nth_element(runs.begin(), runs.begin() + kFieldRuns / 2, runs.end());
    all.push_back({shape.name, shape.default_points, runs[kFieldRuns / 2], seconds_of(options, blob::Method::kPublished)});
  }
  return all;
}

}  // namespace isotouch::commands
