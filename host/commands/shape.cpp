/// isotouch shape: a cloud of one of the project's own objects, whose surface is known exactly.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/board_commands/choice.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/commands/commands.h"
#include "host/commands/progress_bar.h"

namespace isotouch::commands {

namespace {

struct ShapeOptions {
  std::string name;
  std::filesystem::path out;
  std::size_t points = 0;  ///< 0 = the object's own number
  std::uint64_t seed = 1;
  bool json = false;
};

void make_shape(const ShapeOptions& options) {
  const cloud::Shape shape = cloud::shape(options.name);
  const std::size_t count = options.points > 0 ? options.points : shape.default_points;
  constexpr double kSecondsAPoint = 5e-5;
  ProgressBar bar({{"points", kSecondsAPoint * static_cast<double>(count)}});
  bar.begin("points");
  const cloud::OrientedPoints points = sample_shape(shape, count, options.seed);
  bar.end();
  const std::string origin =
      "isotouch shape " + shape.name + " --points " + std::to_string(points.size()) + " --seed " + std::to_string(options.seed);
  cloud::write_ply(options.out, points, origin);
  if (options.json) {
    const nlohmann::ordered_json report = {{"shape", shape.name},
                                           {"made_of", shape.sentence},
                                           {"points", points.size()},
                                           {"seed", options.seed},
                                           {"file", options.out.string()}};
    print_json(report, -1);
  } else {
    std::fprintf(stderr, "%s: %zu points on %s\n", options.out.string().c_str(), points.size(), shape.sentence.c_str());
  }
}

}  // namespace

void add_shape(CLI::App& app) {
  CLI::App* command = app.add_subcommand("shape", "Sample points with exact normals from one of the built-in objects");
  auto options = std::make_shared<ShapeOptions>();
  command->add_option("name", options->name, "the object")->required()->check(one_of(cloud::shape_names()));
  add_output(*command, "-o,--out", options->out, {&forms::kPly}, "the cloud to write")->required();
  command->add_option("--points", options->points, "number of points; each object has its own default")->check(whole_number_in(8, 1000000));
  command->add_option("--seed", options->seed, "seed of the random numbers")->capture_default_str();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    require_apart(options->out, options->json);
    make_shape(*options);
  });
}

}  // namespace isotouch::commands
