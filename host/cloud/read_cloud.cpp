#include "host/cloud/read_cloud.h"

#include <utility>

namespace isotouch::cloud {

OrientedPoints read_cloud(const SourceFile& file, CloudReport& report, bool without_normals) {
  report = CloudReport{};
  report.source_hash = file.hash();
  Model model = file.points();
  if (without_normals) model.normals.clear();
  return check(file.name(), std::move(model), report);
}

Model read_frame(const SourceFile& file) {
  Model model = file.points();
  check_frame(file.name(), model);
  return model;
}

}  // namespace isotouch::cloud
