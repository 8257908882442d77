#include "host/trace/replay.h"

#include <chrono>
#include <cstddef>
#include <string>

#include "host/error.h"
#include "host/trace/hash_text.h"

namespace isotouch::trace {

namespace {

/// A trace names one field, so it ends where another one was loaded.
void check_inputs(const Trace& trace) {
  std::uint32_t generation = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const Input input = trace.record(tick).input;
    const std::uint32_t loaded = input.field_generation;
    const bool moved = (input.requests & kRequestMoved) != 0;
    if (generation != 0 && loaded != 0 && loaded != generation && !moved) {
      throw InputError(trace.path() + ": another field was loaded at record " + std::to_string(tick) +
                       ", but a trace names one field; record it in two parts");
    }
    if (loaded != 0) generation = loaded;
  }
}

/// A recording that ended before a field was loaded names none.
bool may_be_of(const Trace& trace, std::uint64_t field) {
  const std::uint64_t named = trace.header().field_hash;
  return named == field || (named == 0 && trace.kind() == InputKind::kPacket);
}

void check_usable(const FieldView& field, const Trace& trace, bool check) {
  const std::string name = trace.path() + ": ";
  check_inputs(trace);
  require_a_beginning(trace);
  if (!check) return;
  if (!trace.header().has_outputs) throw InputError(name + describe(Error::kNoOutputs) + "; replay it with -o first");
  if (trace.size() == 0) throw InputError(name + "holds no records, there is nothing to compare");
  if (!may_be_of(trace, field.hash())) {
    if (trace.header().field_hash == 0)
      throw InputError(name + "it names no field; see how this one differs with --renderer field, without --check");
    throw InputError(name + "recorded on the field " + hash_text(trace.header().field_hash) + ", and this one is " +
                     hash_text(field.hash()) + "; give that field, or see what the change means with --renderer field, without --check");
  }
}

/// Why a recorded tick is not the one that was computed, given that the ticks before it are. What was stored is told from what was computed
/// by asking which of the two the stored chain belongs to.
std::optional<std::string> difference_at(const Trace& trace, std::size_t tick, const TraceRecord& computed) {
  const TraceRecord stored = trace.record(tick);
  const FieldName output = differing_output(stored.output, computed.output);
  if (!output && stored.chain == computed.chain) return std::nullopt;
  if (output && (stored.chain == computed.chain || trace.chain_follows(tick))) return std::string(output.view());
  const bool chain_goes_on = !output && tick + 1 < trace.size() && !trace.chain_follows(tick + 1);
  return chain_goes_on ? "chain" : "input";
}

ReplayReport run_all(Renderer& renderer, const Trace& trace, bool check, TraceWriter* out, RenderingDifference* difference) {
  if (difference != nullptr && !trace.header().has_outputs) {
    throw InputError(trace.path() + ": " + describe(Error::kNoOutputs) + "; replay it with -o first");
  }
  ReplayReport report;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord recorded = trace.record(tick);
    TraceRecord computed = renderer.step(recorded.input);
    if (check && !report.first_difference) {
      if (const auto name = difference_at(trace, tick, computed)) report.first_difference = Difference{tick, *name};
    }
    if (difference != nullptr) difference->add(trace.kind(), recorded.output, computed.output);
    if (out != nullptr) {
      computed.arrival_ns = recorded.arrival_ns;
      out->append(computed);
    }
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.ticks = trace.size();
  report.hash = renderer.hash();
  return report;
}

}  // namespace

bool has_beginning(const Trace& trace) {
  if (trace.kind() != InputKind::kPacket || !trace.header().has_outputs || trace.size() == 0) return true;
  const TraceRecord first = trace.record(0);
  if ((first.input.requests & kRequestRestart) != 0) return true;
  const TraceHeader& header = trace.header();
  core::TickState fresh;
  const core::TickModel model = core::make_tick_model(header.device, header.settings, header.period_ns);
  // What a controller saves at a fault or after a crash begins in a state that no run begins in, or with a packet that is not the first one heard.
  const Output begun = core::tick(first.input, nullptr, model, fresh);
  return begun.state == first.output.state && (begun.status & kCountJump) == (first.output.status & kCountJump);
}

void require_a_beginning(const Trace& trace) {
  if (has_beginning(trace)) return;
  throw InputError(trace.path() + ": begins in the middle of a run, so it cannot be replayed; look at it with isotouch trace show");
}

TraceHeader replay_header(const FieldView& field, const TraceHeader& inputs) {
  TraceHeader header = inputs;
  header.field_hash = field.hash();
  header.has_outputs = true;
  return header;
}

Run::Run(const FieldView& field, const TraceHeader& header, const RecordedPatches* patches)
    : memory_(patches != nullptr ? patches->memory() : std::array<std::vector<std::uint64_t>, 2>{}),
      field_(field, patches != nullptr ? std::span<const std::uint8_t>(patches->bytes) : std::span<const std::uint8_t>{}, places(memory_)),
      header_(replay_header(field, header)),
      tick_model_(core::make_tick_model(header.device, header.settings, header.period_ns)),
      position_model_(core::make_position_model(header.device, header.settings, header.period_ns, field)),
      chain_(header_) {}

TraceRecord Run::step(const Input& input) {
  TraceRecord record;
  record.input = input;
  if ((input.requests & kRequestMoved) != 0) require_patch(field_.advance(input.moved_to));
  const FieldView& felt = field_.field();
  record.output = input.kind == InputKind::kPosition
                      ? core::render_position(input, felt, position_model_, position_state_)
                      : core::tick(input, input.field_generation == 0 ? nullptr : &felt, tick_model_, tick_state_);
  record.chain = chain_.extend(record.input, record.output);
  return record;
}

ReplayReport replay(const FieldView& field, const Trace& trace, bool check, TraceWriter* out, RenderingDifference* difference) {
  check_usable(field, trace, check);
  const std::optional<RecordedPatches> patches = read_patches(trace, field);
  Run run(field, trace.header(), patches ? &*patches : nullptr);
  return run_all(run, trace, check, out, difference);
}

ReplayReport replay(Renderer& renderer, const Trace& trace, TraceWriter* out, RenderingDifference* difference) {
  check_inputs(trace);
  require_a_beginning(trace);
  return run_all(renderer, trace, false, out, difference);
}

}  // namespace isotouch::trace
