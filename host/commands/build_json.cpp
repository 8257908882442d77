#include "host/commands/build_json.h"

#include "host/commands/verdict_text.h"
#include "host/encoding/dense_bytes.h"
#include "host/trace/hash_text.h"

namespace isotouch::commands {

KindNames names_of(SourceKind kind) {
  switch (kind) {
    case SourceKind::kCloud: return {"cloud", "points"};
    case SourceKind::kMesh: return {"mesh", "vertices"};
    case SourceKind::kLevelSet: break;
  }
  return {"level_set", "voxels"};
}

nlohmann::ordered_json refused_json(const BuildReport& report) {
  return {{"input", names_of(report.kind).kind},
          {"points", report.points},
          {"inside_nodes", report.inside_nodes},
          {"warnings", report.warnings},
          {"verdict", to_json(*report.verdict)}};
}

nlohmann::ordered_json to_json(const BuildReport& report, const FieldView& view) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [stage, seconds] : report.stages) stages[stage] = seconds;
  nlohmann::ordered_json json = {{"input", names_of(report.kind).kind},
                                 {"points", report.points},
                                 {"inside_nodes", report.inside_nodes},
                                 {"seconds", report.seconds},
                                 {"stages", stages},
                                 {"bytes", view.image.size()},
                                 {"wire_bytes", report.packed_bytes},
                                 {"dense_float_bytes", encoding::dense_float_bytes(view)},
                                 {"hash", trace::hash_text(view.hash())},
                                 {"warnings", report.warnings}};
  if (report.verdict) json["verdict"] = to_json(*report.verdict);
  if (report.live_verdict) json["live_verdict"] = to_json(*report.live_verdict);
  return json;
}

}  // namespace isotouch::commands
