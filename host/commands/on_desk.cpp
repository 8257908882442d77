/// The commands of a board, and the renderer that only a desk has.
#include <memory>
#include <optional>
#include <utility>

#include "host/cloud/read_mesh.h"
#include "host/commands/commands.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/god_object_run.h"

namespace isotouch::commands {

namespace {

/// A god-object with the mesh that it feels.
class OnMesh final : public trace::Renderer {
 public:
  /// mesh      closed, workspace, mm
  OnMesh(const FieldView& field, cloud::TriangleMesh mesh, const trace::Trace& trace)
      : mesh_(std::move(mesh)),
        tree_(mesh_),
        patches_(trace::read_patches(trace, field)),
        run_(field, tree_, trace.header(), patches_ ? &*patches_ : nullptr) {}

  TraceRecord step(const Input& input) override { return run_.step(input); }
  std::uint64_t hash() const override { return run_.hash(); }
  const TraceHeader& header() const override { return run_.header(); }

 private:
  cloud::TriangleMesh mesh_;
  field::TriangleTree tree_;
  std::optional<trace::RecordedPatches> patches_;
  evaluate::GodObjectRun run_;
};

/// The mesh is in the cloud's frame, the hand in the workspace: the field's placement leads from one to the other.
std::unique_ptr<trace::Renderer> make_god_object(const FieldView& field, const std::filesystem::path& file, const trace::Trace& trace) {
  const cloud::TriangleMesh mesh = cloud::read_mesh(file);
  cloud::require_closed(mesh, file.string());
  return std::make_unique<OnMesh>(field, cloud::placed(mesh, evaluate::placement_of(field)), trace);
}

}  // namespace

void add_on_desk(CLI::App& app) { add_on_board(app, make_god_object); }

}  // namespace isotouch::commands
