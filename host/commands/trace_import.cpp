/// isotouch trace import: motions that others recorded, as tables or as recordings of ROS 2 and Foxglove.
#include "host/commands/trace_import.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/bag/bag_motion.h"
#include "host/board_commands/number_list.h"
#include "host/commands/new_trace.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/temporary_folder.h"
#include "host/files/whole_file.h"
#include "host/motion/felt_surface.h"
#include "host/motion/motion_csv.h"
#include "host/motion/resample.h"
#include "host/to_double.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

constexpr double kMaxForce = 32767;  // N

struct ImportOptions {
  NewTrace trace;
  fs::path source;
  std::string topic, force_topic;
  std::string given;  ///< an option that changes what is imported; empty: there is none
  std::string columns;
  std::string time_unit;
  std::string length_unit;
  bool forces = false;
  bool centre = false;
  double scale = 1.0;
  std::vector<double> offset = {0, 0, 0};
  fs::path into;
};

/// The grid of a field may be much larger than its object: that of a live field is made for a whole scan.
void warn_unless_it_touches(const std::vector<motion::TimedPoint>& points, const motion::FeltSurface& object,
                            const ImportOptions& options) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector3d way = points[i].position - points[i - 1].position;
    const double steps = std::clamp(std::ceil(way.norm() / object.voxel_mm()), 1.0, 1e4);
    for (double step = 0; step <= steps; ++step) {
      if (object.sample(points[i - 1].position + step / steps * way).distance <= 0) return;
    }
  }
  std::fprintf(stderr,
               "isotouch: %s: the motion never touches the object; the grid of %s is larger than the object. Give --centre, --scale and "
               "--offset instead of --into\n",
               options.source.string().c_str(), options.into.string().c_str());
}

/// Centred first, then scaled, then moved.
void place(std::vector<motion::TimedPoint>& points, ImportOptions options) {
  Eigen::Vector3d low = points.front().position;
  Eigen::Vector3d high = low;
  for (const auto& point : points) {
    low = low.cwiseMin(point.position);
    high = high.cwiseMax(point.position);
  }
  const Eigen::Vector3d middle = options.centre || !options.into.empty() ? Eigen::Vector3d((low + high) / 2) : Eigen::Vector3d::Zero();
  Eigen::Vector3d offset(options.offset[0], options.offset[1], options.offset[2]);
  std::optional<field_file::OpenField> field;
  if (!options.into.empty()) {
    field.emplace(field_file::open_field(options.into));
    const motion::FeltSurface object(field->view);
    const double widest = (high - low).maxCoeff();
    if (!(widest > 0)) throw InputError(options.source.string() + ": the motion stays at one place and cannot be scaled; leave --into out");
    options.scale = object.voxel_mm() * (*std::max_element(field->view.size.begin(), field->view.size.end()) - 1) / widest;
    offset = object.centre();
  }
  for (auto& point : points) point.position = options.scale * (point.position - middle) + offset;
  if (field) warn_unless_it_touches(points, motion::FeltSurface(field->view), options);
}

/// What another device felt, as a tick puts it: the proxy where the stiffness says that the surface was. An input that is not fresh has no contact.
Output felt(const Input& input, const Eigen::Vector3d& force, double stiffness) {
  Output output;
  output.hip = input.hip;
  output.force = to_fixed<Newton>(force);
  output.status = !input.fresh ? kStale : output.force == Vec3<Newton>{} ? 0U : kContact;
  const Eigen::Vector3d hip = to_double(input.hip);
  output.proxy = to_fixed<Mm>(stiffness > 0 ? Eigen::Vector3d(hip + force / stiffness) : hip);
  return output;
}

/// fails     InputError naming the sample: its force or its proxy is more than a trace holds. Of its place, `resample` speaks
void require_in_range(const std::vector<motion::TimedPoint>& points, const ImportOptions& options) {
  const double stiffness = options.trace.stiffness();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string sample = options.source.string() + ": sample " + std::to_string(i + 1);
    if (const double most = points[i].force.cwiseAbs().maxCoeff(); !(most <= kMaxForce))
      throw InputError(sample + " has a force of " + std::to_string(most) + " N, a trace holds ±32767 N; forces are read in N");
    if (!(points[i].position.cwiseAbs().maxCoeff() <= motion::kMaxMm)) continue;
    const Eigen::Vector3d proxy =
        points[i].position + (stiffness > 0 ? Eigen::Vector3d(points[i].force / stiffness) : Eigen::Vector3d::Zero());
    if (const double farthest = proxy.cwiseAbs().maxCoeff(); !(farthest <= motion::kMaxMm)) {
      throw InputError(sample + " has the surface " + std::to_string(farthest) +
                       " mm from the workspace's centre, a trace holds ±2047 mm; give the wall's stiffness in N/mm with --stiffness");
    }
  }
}

/// Nobody but us knows of the copy that we look at.
std::string without_path(const std::string& sentence, const fs::path& copy) {
  const std::string begin = copy.string() + ": ";
  return sentence.starts_with(begin) ? sentence.substr(begin.size()) : sentence;
}

/// A trace that was exported comes back as it was; what else the recording holds is left out.
bool bring_back(const ImportOptions& options) {
  if (!options.topic.empty() || !bag::is_bag(options.source)) return false;
  const std::optional<bag::AttachedTrace> found = bag::attached_trace(options.source);
  if (!found) return false;
  if (!options.given.empty()) {
    throw InputError(options.source.string() + ": it holds a whole trace, which comes back as it was; leave " + options.given +
                     " out, or name the positions to import anew with --topic");
  }
  const TemporaryFolder folder;
  const fs::path looked_at = folder.path / "attached.trace";
  write_file(looked_at, found->trace.data(), found->trace.size());
  if (found->patches) write_file(trace::patches_of(looked_at), found->patches->data(), found->patches->size());
  trace::Trace trace;
  const auto cannot = [&](const std::string& why) {
    return InputError(options.source.string() + ": the trace that it holds cannot be read (" + without_path(why, looked_at) +
                      "); choose a topic with --topic");
  };
  if (const Refusal refusal = files::read_trace(looked_at.string(), trace)) throw cannot(refusal.sentence());
  if (!trace.damage().empty()) throw cannot(trace.damage());
  if (!trace.cut_off().empty())
    std::fprintf(stderr, "isotouch: %s: %s\n", options.source.string().c_str(), without_path(trace.cut_off(), looked_at).c_str());
  std::optional<std::vector<std::uint8_t>> patches;
  try {
    patches = trace::patches_for(options.trace.out, trace);
  } catch (const InputError& error) {
    if (!found->patches) throw cannot("its field was patched, and the patches are not there");
    throw InputError(options.source.string() + ": " + without_path(error.what(), looked_at));
  }
  trace::finish_with_patches(options.trace.out, patches, [&] { write_file(options.trace.out, found->trace.data(), found->trace.size()); });
  std::fprintf(stderr, "%s: the trace that %s holds, to the bit\n", options.trace.out.string().c_str(), options.source.string().c_str());
  return true;
}

/// An option that says nothing about this kind of source would be taken for one that was followed.
void require_fitting(const ImportOptions& options, bool from_bag) {
  if (!options.forces && !options.force_topic.empty()) throw UsageError("--force-topic is for forces; add --forces, or leave it out");
  const auto refuse = [&](const char* option, const char* what) {
    throw UsageError(options.source.string() + ": " + option + " is for " + what + "; leave it out");
  };
  if (from_bag && !options.columns.empty()) refuse("--columns", "a table, and this is a recording with topics");
  if (from_bag && !options.time_unit.empty()) refuse("--time-unit", "a table, and a recording has its times in ns");
  if (!from_bag && !options.topic.empty()) refuse("--topic", "a recording (MCAP, .db3), and this is a table");
  if (!from_bag && !options.force_topic.empty()) refuse("--force-topic", "a recording (MCAP, .db3), and this is a table");
}

void import_table(const ImportOptions& options) {
  if (bring_back(options)) return;
  const bool from_bag = bag::is_bag(options.source);
  require_fitting(options, from_bag);
  motion::MotionColumns columns = motion::parse_columns(options.columns);
  columns.time_unit = options.time_unit;
  columns.length_unit = options.length_unit;
  columns.with_forces = options.forces;
  bag::BagTopics topics{options.topic, options.force_topic, options.forces};
  if (!options.length_unit.empty()) topics.mm_per_unit = motion::millimetres_in(options.length_unit);
  std::vector<motion::TimedPoint> points =
      from_bag ? bag::read_bag_motion(options.source, topics) : motion::read_motion_csv(options.source, columns);
  place(points, options);
  if (options.forces) require_in_range(points, options);
  TickWriter writer(options.trace, options.forces);
  std::uint64_t ticks = 0, unknown = 0, age = 0;
  Vec3<Mm> last;  // the first tick is that of a sample
  try {
    ticks = motion::resample(points, options.trace.header().period_ns, [&](Input input, const std::optional<Eigen::Vector3d>& force) {
      if (!options.forces) return writer(input);
      age = force ? 0 : age + 1;
      unknown += force ? 0U : 1U;
      input.fresh = force.has_value();
      input.hip = last = input.fresh ? input.hip : last;
      input.age = static_cast<std::uint16_t>(std::min<std::uint64_t>(age, UINT16_MAX));
      writer(input, felt(input, force.value_or(Eigen::Vector3d::Zero()), options.trace.stiffness()));
    });
  } catch (const InputError& e) {
    throw InputError(options.source.string() + ": " + e.what());
  }
  writer.finish();
  report(options.trace.out, ticks, options.trace.header());
  if (unknown > 0) {
    std::fprintf(stderr, "%s: %llu of the ticks have no force: they lie between samples that are more than %g s apart\n",
                 options.trace.out.string().c_str(), static_cast<unsigned long long>(unknown), motion::kMaxGap);
  }
}

}  // namespace

void add_import(CLI::App& trace) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = trace.add_subcommand(
      "import",
      "Turn a table of times and positions (with --forces: and forces) into a trace, resampled to the tick period by monotone cubics");
  command
      ->add_option("SOURCE", options->source,
                   "the table, whose first line names the columns; or a recording of ROS 2 or Foxglove (.mcap, .db3)")
      ->required();
  command->add_option("--topic", options->topic,
                      "topic of the positions in a recording (MCAP, .db3); by default the only topic that has positions");
  command->add_option("--force-topic", options->force_topic,
                      "with --forces, topic of the forces in a recording; by default the only topic that has forces");
  command->add_option("--columns", options->columns,
                      "t=NAME,x=NAME,y=NAME,z=NAME,fx=NAME,fy=NAME,fz=NAME (default t_s, x_mm, ..., fx_N, ...)");
  command->add_flag("--forces", options->forces,
                    "also read the forces on the hand, N, for isotouch scan; give the wall's stiffness with --stiffness");
  command->add_option("--time-unit", options->time_unit, "s ms us ns; default: the last word of the column's name, as in t_ms");
  command->add_option("--length-unit", options->length_unit,
                      "mm cm m in; default: the last word of the columns' names, as in x_m; m in a recording");
  command->add_flag("--centre", options->centre, "put the middle of the motion's box at the workspace's centre");
  command->add_option("--scale", options->scale, "then multiply")->capture_default_str();
  take_numbers(command->add_option("--offset", options->offset, "then move the motion by so much, mm"), "X,Y,Z");
  command
      ->add_option(
          "--into", options->into,
          "instead of --centre, --scale and --offset: centre the motion in this field's grid and make its longest side as long as the "
          "grid's, which is larger than the object")
      ->excludes("--centre")
      ->excludes("--scale")
      ->excludes("--offset");
  options->trace.add_to(*command);
  command->callback([options, command] {
    for (const CLI::Option* option : command->get_options()) {
      if (option->count() > 0 && !option->get_positional() && !option->check_lname("out")) options->given = option->get_name();
    }
    import_table(*options);
  });
}

}  // namespace isotouch::commands
