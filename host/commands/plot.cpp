/// isotouch plot: forces and times as curves and histograms.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/controller_options.h"
#include "host/board_commands/number_in.h"
#include "host/commands/commands.h"
#include "host/commands/picture_options.h"
#include "host/commands/recorded_ticks.h"
#include "host/error.h"
#include "host/evaluate/exact_sphere.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/trace/felt_settings.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "host/view/caption.h"
#include "host/view/force_picture.h"
#include "host/view/histogram_plot.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

/// What a hand felt: the force of each tick, and when there was contact.
struct Felt {
  view::ForceCurve curve;
  std::vector<std::pair<double, double>> contacts;
};

/// each      is called with every tick, too
template <class Each>
Felt felt_in(const trace::Trace& recorded, const FieldView* field, const Each& each) {
  Felt felt;
  const double period_s = recorded.header().period_ns * 1e-9;
  bool touched = false;
  for_each_tick(recorded, field, [&](std::size_t tick, const TraceRecord& record) {
    const double now = static_cast<double>(tick) * period_s;
    felt.curve.time_s.push_back(now);
    felt.curve.force.push_back(to_double(record.output.force));
    const bool touches = (record.output.status & kContact) != 0;
    if (touches && !touched) felt.contacts.emplace_back(now, now);
    if (touches) felt.contacts.back().second = now + period_s;
    touched = touches;
    each(record);
  });
  return felt;
}

struct ForceRun {
  PictureOptions picture;
  fs::path trace, other, field;
  double sphere_mm = 0;

  void operator()() const {
    const trace::Trace recorded = trace::read_trace(trace);
    std::optional<field_file::OpenField> open;
    if (!field.empty()) open.emplace(field_file::open_field(field));
    const FieldView* touched = open ? &open->view : nullptr;
    const bool states_settings = trace::has_beginning(recorded);
    if (sphere_mm > 0 && !states_settings) {
      throw InputError(trace.string() +
                       ": begins in the middle of a run and does not state the settings of its first tick, so there is no exact answer; "
                       "leave out --exact-sphere");
    }
    trace::FeltSettings settings(recorded.header(), sphere_mm > 0 ? stiffness_of(recorded, touched) : Stiffness{});
    std::vector<double> limits;
    view::ForceCurve exact{"exact, sphere of " + view::number(sphere_mm, 3) + " mm", {}, {}};
    Felt felt = felt_in(recorded, touched, [&](const TraceRecord& record) {
      const TickSettings now = settings.next(record);
      const double limit = to_double(now.force_limit);
      if (states_settings) limits.push_back(limit);
      if (sphere_mm <= 0) return;
      const double newtons = evaluate::exact_sphere_force(recorded.kind(), record.output, sphere_mm, to_double(now.stiffness), limit);
      exact.force.push_back(newtons * to_double(record.output.hip).normalized());
    });
    view::ForceOptions options{.width = picture.size[0],
                               .height = picture.size[1],
                               .title = trace.stem().string(),
                               .contacts = std::move(felt.contacts),
                               .limits_n = std::move(limits)};
    std::optional<view::ForceCurve> beside;
    if (sphere_mm > 0) {
      exact.time_s = felt.curve.time_s;
      beside = std::move(exact);
    } else if (!other.empty()) {
      const trace::Trace second = trace::read_trace(other);
      if (second.header().period_ns != recorded.header().period_ns)
        throw InputError(other.string() + ": its ticks are " + std::to_string(second.header().period_ns) + " ns apart, and those of " +
                         trace.string() + " " + std::to_string(recorded.header().period_ns) + " ns; compare traces of the same rate");
      beside = felt_in(second, touched, [](const TraceRecord&) {}).curve;
      beside->label = other.stem().string();
      options.difference = "difference to " + beside->label;
    }
    const std::string source = recorded.header().has_outputs ? "as recorded" : "as the core renders it";
    felt.curve.label = sphere_mm > 0 || other.empty() ? source : trace.stem().string();
    view::write_picture(picture.out, view::force_picture(felt.curve, beside ? &*beside : nullptr, options));
  }

  /// Where the recording begins.
  Stiffness stiffness_of(const trace::Trace& recorded, const FieldView* touched) const {
    const Stiffness set = recorded.header().settings.stiffness;
    if (set.raw() != 0) return set;
    if (touched == nullptr)
      throw InputError(trace.string() + ": it states no stiffness, because that of the field was used; name the field with --field");
    return touched->stiffness;
  }
};

struct LatencyRun {
  PictureOptions picture;
  fs::path figures, other;

  void operator()() const {
    const std::vector<view::HistogramPlot> plots = plots_of(figures, other);
    view::Picture drawn(picture.size[0], picture.size[1]);
    view::Canvas canvas(drawn);
    constexpr std::size_t kColumns = 2;
    const std::size_t rows = (plots.size() + kColumns - 1) / kColumns;
    const float width = static_cast<float>(picture.size[0]) / kColumns,
                height = static_cast<float>(picture.size[1]) / static_cast<float>(rows);
    for (std::size_t i = 0; i < plots.size(); ++i) {
      const float left = static_cast<float>(i % kColumns) * width, top = static_cast<float>(i / kColumns) * height;
      plots[i].draw(canvas, {left, top, left + width, top + height});
    }
    view::write_picture(picture.out, drawn);
  }

 private:
  static nlohmann::json read(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = read_file(file);
    return nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  }

  static std::vector<view::ValueClass> classes_of(const nlohmann::json& all, const char* key, const fs::path& file) {
    const auto wrong = [&] {
      return InputError(file.string() + ": it holds no histograms of times, '" + key +
                        "' is missing or of another form; make it with isotouch latency --json");
    };
    if (!all.is_object() || !all.contains(key)) throw wrong();
    const nlohmann::json& measure = all[key];
    if (!measure.is_object() || !measure.contains("bins") || !measure["bins"].is_array()) throw wrong();
    std::vector<view::ValueClass> classes;
    for (const nlohmann::json& bin : measure["bins"]) {
      const auto number = [&](const char* name) {
        return bin.is_object() && bin.contains(name) && bin[name].is_number() ? bin[name].get<double>() : -1;
      };
      const view::ValueClass c{number("up_to"), number("count")};
      if (!(c.up_to >= 0) || !(c.up_to < 1e12) || !(c.count >= 0) || !(c.count < 1e19)) throw wrong();
      if (!classes.empty() && c.up_to <= classes.back().up_to) throw wrong();
      classes.push_back(c);
    }
    return classes;
  }

  static std::vector<view::HistogramPlot> plots_of(const fs::path& file, const fs::path& other) {
    const nlohmann::json first = read(file), second = other.empty() ? nlohmann::json() : read(other);
    std::vector<view::HistogramPlot> plots;
    for (const MeasureName& measure : kMeasureNames) {
      view::HistogramPlot plot{measure.text, measure.in_ticks ? "ticks" : "us", classes_of(first, measure.key, file), {}, {}, {}, {}};
      if (!other.empty()) {
        plot.beside = classes_of(second, measure.key, other);
        plot.label = file.stem().string();
        plot.beside_label = other.stem().string();
      }
      plots.push_back(std::move(plot));
    }
    return plots;
  }
};

}  // namespace

void add_plot(CLI::App& app) {
  CLI::App* plot = app.add_subcommand("plot", "Draw forces over time, or histograms of times, alone or beside another run");
  plot->require_subcommand(1);

  const auto [force, force_run] =
      add_picture<ForceRun>(*plot, "force", "The force of a recorded hand over time, with the times of contact and the force limit");
  force->add_option("TRACE", force_run->trace, "the recorded hand (.trace)")->required();
  CLI::Option* other =
      force->add_option("OTHER", force_run->other, "another one, drawn over it; below, the length of the difference of the forces");
  force->add_option("--field", force_run->field, "the field; needed if a trace holds inputs only, or takes its stiffness from the field");
  force->add_option("--exact-sphere", force_run->sphere_mm, "also draw the exact force of a sphere of this radius (mm) around the origin")
      ->check(number_in(0.001, 10000.0))
      ->excludes(other);

  const auto [latency, latency_run] = add_picture<LatencyRun>(*plot, "latency", "The histograms that isotouch latency --json prints");
  latency->add_option("FIGURES", latency_run->figures, "what isotouch latency --json printed; - is standard input")->required();
  latency->add_option("OTHER", latency_run->other, "those of another run, drawn over them as a line");
}

}  // namespace isotouch::commands
