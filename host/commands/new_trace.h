/// What the commands that write new traces have in common: the options of the header, and ticks that follow each other.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "host/board_commands/output.h"
#include "host/commands/quantities.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::commands {

/// The options of the tick settings, in the order of kTickSettingRows.
inline constexpr std::array<const char*, kTickSettings> kSettingOptions = {
    "--stiffness", "--damping", "--force-limit",    "--friction", "--friction-damping", "--hand-damping", "--passivity-damping",
    "--weight",    "--ramp",    "--device-damping", "--delay"};

/// What every new trace has in its header.
struct NewTrace {
  std::filesystem::path out;
  double period_ms = rows::kPeriod.standard / kNsPerMs;
  std::array<double, kTickSettings> settings{};  ///< in the unit of each row

  NewTrace() {
    for (std::size_t i = 0; i < kTickSettings; ++i) settings[i] = kTickSettingRows[i]->standard;
  }

  void add_to(CLI::App& command) {
    add_output(command, "-o,--out", out, {&forms::kTrace}, "the trace to write")->required();
    command.add_option("--period", period_ms, "tick period")
        ->transform(quantity({{"ms", 1.0}, {"us", 0.001}, {"s", 1000.0}}, rows::kPeriod.low / kNsPerMs, rows::kPeriod.high / kNsPerMs))
        ->capture_default_str();
    for (std::size_t i = 0; i < kTickSettings; ++i) {
      command.add_option(kSettingOptions[i], settings[i], std::string(kTickSettingRows[i]->meaning))
          ->transform(value_of(*kTickSettingRows[i]))
          ->capture_default_str();
    }
  }

  TraceHeader header() const {
    TraceHeader made;
    made.period_ns = static_cast<std::uint32_t>(period_ms * kNsPerMs + 0.5);
    RawSettings raw{};
    for (std::size_t i = 0; i < kTickSettings; ++i) raw[i] = kTickSettingRows[i]->raw(settings[i]);
    made.settings = from_raw(raw);
    return made;
  }

  /// N/mm.
  double stiffness() const { return settings[index_of(TickSetting::kStiffness)]; }

 private:
  static constexpr double kNsPerMs = 1e6;
};

/// Writes ticks as they come, one period apart. Until it is finished, the file stays as it was.
///
/// fails     InputError when it cannot be written
class TickWriter {
 public:
  TickWriter(const NewTrace& trace, bool has_outputs)
      : header_(with_outputs(trace.header(), has_outputs)), writer_(trace.out, header_), chain_(header_) {}
  void operator()(const Input& input) { writer_.append({input, {}, 0, header_.period_ns * tick_++}); }
  /// Only with outputs.
  void operator()(const Input& input, const Output& output) {
    writer_.append({input, output, chain_.extend(input, output), header_.period_ns * tick_++});
  }
  void finish() { writer_.finish(); }

 private:
  static TraceHeader with_outputs(TraceHeader header, bool has_outputs) {
    header.has_outputs = has_outputs;
    return header;
  }
  TraceHeader header_;
  trace::TraceWriter writer_;
  Chain chain_;
  std::uint64_t tick_ = 0;
};

/// Says on standard error what was written, with its time in seconds.
inline void report(const std::filesystem::path& file, std::uint64_t ticks, const TraceHeader& header) {
  std::fprintf(stderr, "%s: %llu ticks, %.3f s\n", file.string().c_str(), static_cast<unsigned long long>(ticks),
               static_cast<double>(ticks) * header.period_ns * 1e-9);
}

}  // namespace isotouch::commands
