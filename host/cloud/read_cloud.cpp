#include "host/cloud/read_cloud.h"

namespace isotouch::cloud {

OrientedPoints read_cloud(const SourceFile& file, CloudReport& report) {
  report = CloudReport{};
  report.source_hash = file.hash();
  return check(file.name(), file.points(), report);
}

}  // namespace isotouch::cloud
