#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/cloud/mesh_bytes.h"
#include "host/cloud/ply.h"
#include "host/error.h"
#include "host/evaluate/god_object_run.h"
#include "host/evaluate/zero_surface.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/trace/recorded_patches.h"
#include "tests/host/commands/run_command.h"
#include "tests/host/evaluate/ball_mesh.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

using Json = nlohmann::json;

/// `isotouch replay` with these arguments.
std::string replay(const std::string& arguments) {
  CLI::App app;
  add_on_desk(app);
  testing::internal::CaptureStdout();
  try {
    app.parse("replay " + arguments);
  } catch (...) {
    testing::internal::GetCapturedStdout();
    throw;
  }
  return testing::internal::GetCapturedStdout();
}

/// What a refusal says.
std::string refusal(const std::string& arguments) {
  try {
    replay(arguments);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Replay, KeepsThePatchesOfAFieldBesideWhatItWrites) {
  const ScratchFolder folder;
  const std::string golden = ISOTOUCH_GOLDEN "/field_1_3.itf " ISOTOUCH_GOLDEN "/positions_patches.trace",
                    out = (folder.path() / "a.trace").string();
  replay(golden + " -o " + out);
  EXPECT_EQ(read_file(folder.path() / "a.patches"), read_file(ISOTOUCH_GOLDEN "/positions_patches.patches"));
  EXPECT_THAT(replay(ISOTOUCH_GOLDEN "/field_1_3.itf " + out + " --check"), testing::HasSubstr("equal to the recorded outputs"));
  EXPECT_THAT(refusal(golden + " -o -"), testing::HasSubstr("write to a file, not to -"));
}

TEST(Replay, NothingIsWrittenOfARecordingThatWasChanged) {
  const ScratchFolder folder;
  std::vector<std::uint8_t> bytes = read_file(ISOTOUCH_GOLDEN "/positions_patches.trace");
  bytes[bytes.size() - 2 * trace_layout::kRecordBytes + trace_layout::kOutputAt] ^= 1;
  const std::string changed = folder.write("b.trace", {bytes.begin(), bytes.end()}).string(), out = (folder.path() / "a.trace").string();
  std::filesystem::copy_file(ISOTOUCH_GOLDEN "/positions_patches.patches", folder.path() / "b.patches");
  const std::string arguments = ISOTOUCH_GOLDEN "/field_1_3.itf " + changed + " --check";
  EXPECT_THROW(replay(arguments), ComparisonFailed) << "to look at the damage";
  EXPECT_THAT(refusal(arguments + " -o " + out), testing::HasSubstr("its bytes were changed after they were recorded"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

/// The golden field does not say how its scan was placed, so the mesh is put where the field is.
TEST(Replay, AGodObjectFeelsARecordingUnderAStream) {
  const auto field = field_file::open_field(ISOTOUCH_GOLDEN "/field_1_3.itf");
  const auto trace = trace::read_trace(ISOTOUCH_GOLDEN "/positions_patches.trace");
  const auto patches = trace::read_patches(trace, field.view);
  ASSERT_TRUE(patches);
  const cloud::TriangleMesh mesh = evaluate::zero_surface(field.view);
  const field::TriangleTree tree(mesh);
  evaluate::GodObjectRun run(field.view, tree, trace.header(), &*patches);
  std::size_t touching = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) touching += (run.step(trace.record(tick).input).output.status & kContact) != 0;
  EXPECT_GT(touching, 100U);
}

/// A ball far from the origin of its scan and in units of its own: the tool makes it 42 mm long and puts it into the workspace's middle.
class ReplayRenderer : public testing::Test {
 protected:
  static constexpr double kRadius = 3.5, kScale = 6;
  const Eigen::Vector3d kMiddle{50, -20, 7};

  void SetUp() override {
    mesh("true.ply", Eigen::Vector3d::Zero());
    run_command("build " + file("true.ply") + " --fit 42mm --grid 120 -o " + file("ball.itf"));
    run_command("trace make tour " + file("ball.itf") + " --ticks 6000 -o " + file("hand.trace"));
    replay(file("ball.itf") + " " + file("hand.trace") + " -o " + file("felt.trace"));
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string felt() const { return file("ball.itf") + " " + file("felt.trace"); }
  /// by     mm in the workspace
  cloud::TriangleMesh ball_at(const Eigen::Vector3d& by) const {
    cloud::TriangleMesh made = evaluate::ball(kRadius, 6);
    for (Eigen::Vector3d& vertex : made.vertices) vertex += kMiddle + by / kScale;
    return made;
  }
  void mesh(const std::string& name, const Eigen::Vector3d& by) const {
    const std::vector<std::uint8_t> bytes = cloud::ply_bytes(ball_at(by), "ball");
    write_file(file(name), bytes.data(), bytes.size());
  }
  Json difference(const std::string& options) const { return Json::parse(replay(felt() + options + " --json")).at("difference"); }

 private:
  ScratchFolder folder_;
};

TEST_F(ReplayRenderer, TheFieldOfTheRecordingDiffersInNoBit) {
  const Json same = difference(" --renderer field --check");
  EXPECT_GT(same.at("touching"), 500);
  EXPECT_EQ(same.at("force_n").at("max"), 0);
  EXPECT_EQ(same.at("proxy_mm").at("max"), 0);
  EXPECT_EQ(same.at("contact_differs"), 0);
}

TEST_F(ReplayRenderer, AGodObjectOnTheTrueMeshFeelsNearlyTheSame) {
  const Json exact = difference(" --renderer god-object --mesh " + file("true.ply"));
  EXPECT_GT(exact.at("direction_deg").at("p95"), 0.4) << "half the angle between faces is 0.6";
  EXPECT_LT(exact.at("direction_deg").at("p95"), 1.2);
  EXPECT_GT(exact.at("force_n").at("p95"), 0.008);
  EXPECT_LT(exact.at("force_n").at("p95"), 0.03);
  EXPECT_GT(exact.at("shallow").at("force_n").at("p95"), 0.003);
  EXPECT_LT(exact.at("shallow").at("force_n").at("p95"), 0.012);
}

TEST_F(ReplayRenderer, AMeshThatIsElsewhereIsFound) {
  mesh("moved.ply", {0.3, 0, 0});
  const Json sound = difference(" --renderer god-object --mesh " + file("true.ply"));
  const Json moved = difference(" --renderer god-object --mesh " + file("moved.ply"));
  EXPECT_GT(moved.at("force_n").at("median").get<double>(), 3 * sound.at("force_n").at("median").get<double>());
  EXPECT_GT(moved.at("force_n").at("max"), 0.2) << "0.8 N/mm times 0.3 mm";
}

TEST_F(ReplayRenderer, ThePapersRendererDiffersMoreThanAGodObject) {
  cloud::write_ply(file("points.ply"), cloud::scatter_on_mesh(ball_at({0, 0, 0}), 3000, 1));
  run_command("build " + file("points.ply") + " --method published --fit 42mm --grid 60 -o " + file("published.itf"));
  const Json published =
      Json::parse(replay(file("published.itf") + " " + file("felt.trace") + " --renderer published --json")).at("difference");
  EXPECT_GT(published.at("direction_deg").at("p95"), 4);
  EXPECT_LT(published.at("direction_deg").at("p95"), 40);
}

TEST_F(ReplayRenderer, TheTextHasAllFigures) {
  const std::string text = replay(felt() + " --renderer god-object --mesh " + file("true.ply"));
  for (const char* word :
       {"god-object beside the recording: ", "only one of the two touches", "force, N", "direction, deg", "proxy, mm", "p99"})
    EXPECT_THAT(text, testing::HasSubstr(word));
  EXPECT_THAT(replay(felt()), testing::Not(testing::HasSubstr("beside the recording"))) << "as ever, unless it is asked for";
}

TEST_F(ReplayRenderer, AGodObjectsTraceNamesNoField) {
  replay(felt() + " --renderer god-object --mesh " + file("true.ply") + " -o " + file("god.trace"));
  EXPECT_THAT(refusal(file("ball.itf") + " " + file("god.trace") + " --check"),
              testing::HasSubstr("god.trace: it names no field; see how this one differs with --renderer field, without --check"));
  const Json back = Json::parse(replay(file("ball.itf") + " " + file("god.trace") + " --renderer field --json")).at("difference");
  const Json there = difference(" --renderer god-object --mesh " + file("true.ply"));
  EXPECT_EQ(back, there) << "a difference has no direction";
}

TEST_F(ReplayRenderer, RefusesWhatItCannotRenderInOneSentence) {
  EXPECT_THAT(refusal(felt() + " --renderer published"), testing::HasSubstr("isotouch build CLOUD --method published"));
  EXPECT_THAT(refusal(felt() + " --renderer god-object"), testing::HasSubstr("--mesh"));
  EXPECT_THAT(refusal(felt() + " --mesh " + file("true.ply")), testing::HasSubstr("add --renderer god-object"));
  EXPECT_THAT(refusal(felt() + " --renderer god-object --check --mesh " + file("true.ply")), testing::HasSubstr("--check"));
  EXPECT_THAT(refusal(file("ball.itf") + " " + file("hand.trace") + " --renderer field"), testing::HasSubstr("nothing to compare"));
  EXPECT_THAT(refusal(felt() + " --renderer god-object --mesh " + file("none.ply")), testing::HasSubstr("none.ply"));
}

TEST_F(ReplayRenderer, RefusesMotorCommandsOfAGodObject) {
  run_command("trace to-packets " + file("ball.itf") + " " + file("hand.trace") + " -o " + file("device.trace"));
  const std::string device = file("ball.itf") + " " + file("device.trace") + " --renderer god-object --mesh " + file("true.ply");
  EXPECT_THAT(refusal(device + " -o " + file("no.trace")), testing::HasSubstr("motor commands"));
  const Json exact = Json::parse(replay(device + " --json")).at("difference");
  EXPECT_GT(exact.at("force_n").at("p95"), 0.0005);
  EXPECT_LT(exact.at("force_n").at("p95"), 0.04);
}

TEST_F(ReplayRenderer, AHandThatTouchesNothingComparesNothing) {
  run_command("trace make leave " + file("ball.itf") + " --ticks 3 -o " + file("away.trace"));
  replay(file("ball.itf") + " " + file("away.trace") + " -o " + file("away-felt.trace"));
  EXPECT_THAT(refusal(file("ball.itf") + " " + file("away-felt.trace") + " --renderer field"), testing::HasSubstr("nothing to compare"));
}

}  // namespace
}  // namespace isotouch::commands
