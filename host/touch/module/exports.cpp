/// touch.wasm: one `Session` behind plain functions, for host/page/src/touch/touch.ts, which is the only caller. No imports, no floating-point text, no
/// allocation but `memory.grow`.
///
/// A function that can refuse returns the address of a sentence that ends with a zero byte, or 0. Numbers pass through `numbers()`, 64-bit floats. An address
/// stays valid; a view of the memory does not when the memory has grown, which any function with `room`, `run` or `replay` in its name may cause.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hil/plain_replay.h"
#include "host/touch/module/memory.h"
#include "host/touch/session.h"
#include "shared/patch_chain.h"

#define TOUCH_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace {

using namespace isotouch;
using touch::Refused;

constexpr std::size_t kBatch = 1000;         // places at a time
constexpr std::size_t kNumbersOfATick = 12;  // HIP, proxy, force, penetration, energy, status
constexpr std::uint64_t kGrowth = std::uint64_t{1} << 20;

constexpr Refused kNoMemory = "there is not enough memory for it";
constexpr Refused kTooMany = "at most 1000 places at a time";

struct Module {
  touch::Session session;
  std::size_t image_bytes = 0;
  std::uint64_t max_trace_bytes = 0;
  std::size_t replayed_bytes = 0;
  std::size_t patches_bytes = 0;
  std::uint64_t replay_hash = 0;
  std::array<double, 3 * kBatch> places{};
  std::array<double, kNumbersOfATick * kBatch> numbers{};
  std::array<std::uint8_t, kDeviceModelBytes> device{};
};

Module& module() {
  static Module only;
  return only;
}

std::uint64_t trace_begin() { return image_layout::align64(std::uint64_t{module().image_bytes}); }

/// Memory for the trace to grow into; none where there is no more, which ends the trace.
std::span<std::uint8_t> trace_room(std::uint64_t bytes) {
  const std::span<std::uint8_t> block = touch::block_of(trace_begin() + std::min(bytes, module().max_trace_bytes));
  return block.empty() ? block : block.subspan(static_cast<std::size_t>(trace_begin()));
}

/// A trace that fills its room goes on in a larger one.
void make_room() {
  Module& m = module();
  if (m.max_trace_bytes == 0 || !m.session.is_full()) return;
  const std::uint64_t bytes = trace_layout::kHeaderBytes + m.session.recorded() * trace_layout::kRecordBytes;
  if (bytes + trace_layout::kRecordBytes > m.max_trace_bytes) return;
  const std::span<std::uint8_t> room = trace_room(bytes + kGrowth);
  if (!room.empty()) m.session.extend_room(room);
}

void begin_trace() {
  Module& m = module();
  m.session.record_into(m.max_trace_bytes == 0 ? std::span<std::uint8_t>{} : trace_room(kGrowth));
}

const SettingRow& row(std::size_t number) { return *kTickSettingRows[std::min(number, kTickSettings - 1)]; }

/// Texts of the tables are literals: a zero byte ends them.
const char* text(std::string_view literal) { return literal.data(); }

}  // namespace

// ---- the field --------------------------------------------------------------------------------------------------------------------

/// Forgets the field and its trace. returns the address of room for an image of that many bytes; 0 when there is not enough memory
TOUCH_EXPORT(image_room) std::uint8_t* image_room(double bytes) {
  Module& m = module();
  m.session.unload();
  m.image_bytes = 0;
  m.max_trace_bytes = 0;
  begin_trace();
  if (!(bytes >= 0 && bytes < 4294967296.0)) return nullptr;
  const std::span<std::uint8_t> block = touch::block_of(std::max(static_cast<std::uint64_t>(bytes), std::uint64_t{1}));
  if (block.empty()) return nullptr;
  m.image_bytes = static_cast<std::size_t>(bytes);
  return block.data();
}

/// Checks the image that was written into its room, and loads it.
TOUCH_EXPORT(load) Refused load() { return module().session.load({touch::block_begin(), module().image_bytes}); }

/// Puts ten numbers into `numbers()`: place of the first sample (3, mm), edge of a voxel (mm), samples along each axis (3), band (mm), largest stiffness
/// (N/mm), period for which the settings stand (ns).
TOUCH_EXPORT(field_numbers) Refused field_numbers() {
  Module& m = module();
  const std::optional<FieldView>& field = m.session.field();
  if (!field) return "there is no field; load one first";
  const auto scaled = [](auto q) {
    return static_cast<double>(q.raw()) / static_cast<double>(std::int64_t{1} << decltype(q)::kFractionBits);
  };
  const double edge = scaled(field->edge);
  m.numbers[0] = scaled(field->origin.x), m.numbers[1] = scaled(field->origin.y), m.numbers[2] = scaled(field->origin.z);
  m.numbers[3] = edge;
  for (std::size_t i = 0; i < 3; ++i) m.numbers[4 + i] = field->size[i];
  m.numbers[7] = scaled(field->band) * edge;
  m.numbers[8] = scaled(field->stiffness);
  m.numbers[9] = m.session.period_ns();
  return nullptr;
}

/// The hash that names the field; 0 without one.
TOUCH_EXPORT(field_hash) std::uint64_t field_hash() { return module().session.field() ? module().session.field()->hash() : 0; }

// ---- settings ---------------------------------------------------------------------------------------------------------------------

TOUCH_EXPORT(setting_count) std::size_t setting_count() { return kTickSettings; }
TOUCH_EXPORT(setting_name) const char* setting_name(std::size_t number) { return text(row(number).name); }
TOUCH_EXPORT(setting_unit) const char* setting_unit(std::size_t number) { return text(row(number).unit); }
TOUCH_EXPORT(setting_meaning) const char* setting_meaning(std::size_t number) { return text(row(number).meaning); }
TOUCH_EXPORT(setting_low) double setting_low(std::size_t number) { return row(number).low; }
TOUCH_EXPORT(setting_high) double setting_high(std::size_t number) { return row(number).high; }
TOUCH_EXPORT(setting_standard) double setting_standard(std::size_t number) { return row(number).standard; }
TOUCH_EXPORT(setting_may_be_unset) bool setting_may_be_unset(std::size_t number) { return row(number).zero_means_unset; }
TOUCH_EXPORT(setting) double setting(std::size_t number) { return module().session.setting(number); }
TOUCH_EXPORT(set) Refused set(std::size_t number, double value) { return module().session.set(number, value); }
TOUCH_EXPORT(set_period) Refused set_period(double ns) { return module().session.set_period(ns); }

/// Where the 128 bytes of the device model stand, those of shared/SPEC.md, section 5: written here by `standard_device`, or by the page before `set_device`.
TOUCH_EXPORT(device_bytes) std::uint8_t* device_bytes() { return module().device.data(); }
/// which   0 the model of libnifalcon, 1 of Martin and Hillier
TOUCH_EXPORT(standard_device) void standard_device(std::size_t which) {
  module().device = encode(which == 1 ? martin_hillier_model() : libnifalcon_model());
}
TOUCH_EXPORT(set_device) Refused set_device() { return module().session.set_device(module().device); }

// ---- touching ---------------------------------------------------------------------------------------------------------------------

TOUCH_EXPORT(batch) std::size_t batch() { return kBatch; }
/// Where places go in: three coordinates each, mm.
TOUCH_EXPORT(places) double* places() { return module().places.data(); }
/// Where numbers come out.
TOUCH_EXPORT(numbers) double* numbers() { return module().numbers.data(); }

/// One tick for each of the first `count` places. Of each, twelve numbers come out: HIP (3, mm), proxy (3, mm), force (3, N), penetration (mm), work
/// done on the hand (mJ), status bits. The first place that is refused ends the run; the ticks before it have happened.
TOUCH_EXPORT(run) Refused run(std::size_t count, std::uint32_t buttons) {
  Module& m = module();
  if (count > kBatch) return kTooMany;
  for (std::size_t i = 0; i < count; ++i) {
    make_room();
    touch::Felt felt;
    const double* at = &m.places[3 * i];
    if (const Refused refused = m.session.tick({at[0], at[1], at[2]}, static_cast<std::uint8_t>(buttons & 0xF), felt)) return refused;
    double* out = &m.numbers[kNumbersOfATick * i];
    out = std::copy(felt.hip.begin(), felt.hip.end(), out);
    out = std::copy(felt.proxy.begin(), felt.proxy.end(), out);
    out = std::copy(felt.force.begin(), felt.force.end(), out);
    *out++ = felt.penetration;
    *out++ = felt.energy;
    *out = felt.status;
  }
  return nullptr;
}

/// The hand leaves.
TOUCH_EXPORT(lift) void lift() { module().session.lift(); }

/// The field's distance, mm, at each of the first `count` places.
TOUCH_EXPORT(sample) Refused sample(std::size_t count) {
  Module& m = module();
  if (count > kBatch) return kTooMany;
  for (std::size_t i = 0; i < count; ++i) {
    const double* at = &m.places[3 * i];
    if (const Refused refused = m.session.sample({at[0], at[1], at[2]}, m.numbers[i])) return refused;
  }
  return nullptr;
}

// ---- the trace --------------------------------------------------------------------------------------------------------------------

/// Begins a trace of at most that many ticks; 0 ends it and frees its memory for another.
TOUCH_EXPORT(record_room) Refused record_room(double max_ticks) {
  Module& m = module();
  if (!m.session.field()) return "there is no field; load one first";
  if (!(max_ticks >= 0 && max_ticks <= 40'000'000)) return "a trace has at most 40,000,000 ticks";
  const auto ticks = static_cast<std::uint64_t>(max_ticks);
  m.max_trace_bytes = ticks == 0 ? 0 : trace_layout::kHeaderBytes + ticks * trace_layout::kRecordBytes;
  begin_trace();
  if (ticks > 0 && trace_room(kGrowth).empty()) return kNoMemory;
  return nullptr;
}
/// Ticks in the trace.
TOUCH_EXPORT(recorded) double recorded() { return static_cast<double>(module().session.recorded()); }
/// Does the trace wait until the hand touches nothing?
TOUCH_EXPORT(waits) bool waits() { return module().session.waits(); }
/// Finishes the trace's header. returns its bytes; 0 without a tick
TOUCH_EXPORT(trace_bytes) std::size_t trace_bytes() { return module().session.trace().size(); }
/// Where the trace begins.
TOUCH_EXPORT(trace_address) const std::uint8_t* trace_address() { return module().session.trace().data(); }

// ---- a recording ------------------------------------------------------------------------------------------------------------------

/// Ends the trace that is kept. returns the address of room for a recording of that many bytes; 0 when there is not enough memory. The patches of its field,
/// if it has any, belong behind it, at the next multiple of 64 bytes.
TOUCH_EXPORT(replay_room) std::uint8_t* replay_room(double bytes, double patches_bytes) {
  Module& m = module();
  m.max_trace_bytes = 0;
  m.replayed_bytes = 0;
  m.patches_bytes = 0;
  begin_trace();
  if (!(bytes >= 0 && bytes < 4294967296.0 && patches_bytes >= 0 && patches_bytes < 4294967296.0)) return nullptr;
  const auto size = static_cast<std::uint64_t>(bytes), patches_size = static_cast<std::uint64_t>(patches_bytes);
  const std::span<std::uint8_t> block =
      touch::block_of(trace_begin() + image_layout::align64(size) + std::max(patches_size, std::uint64_t{1}));
  if (block.empty()) return nullptr;
  m.replayed_bytes = static_cast<std::size_t>(size);
  m.patches_bytes = static_cast<std::size_t>(patches_size);
  return block.data() + trace_begin();
}

/// Replays the recording that was written into its room, of positions or of a device's packets, on the loaded field. Three numbers come out: ticks, 1 if
/// every bit is that of the recording, else 0 and, third, the first tick that is not. The hash is that of `isotouch replay`.
TOUCH_EXPORT(replay) Refused replay_recording() {
  Module& m = module();
  const std::optional<FieldView>& field = m.session.field();
  if (!field) return "there is no field; load one first";
  const std::uint64_t patches_begin = trace_begin() + image_layout::align64(std::uint64_t{m.replayed_bytes});
  const Result<Patches> patches = check_patches({touch::block_begin() + patches_begin, m.patches_bytes}, *field);
  if (!patches) return describe(patches.error());
  const std::uint64_t images_begin = image_layout::align64(patches_begin + m.patches_bytes);
  const std::uint64_t images_step = image_layout::align64(std::uint64_t{patches->largest_image});
  const std::span<std::uint8_t> block = touch::block_of(images_begin + 2 * images_step);
  if (block.empty()) return kNoMemory;
  const auto part = [&](std::uint64_t begin, std::size_t bytes) { return block.subspan(static_cast<std::size_t>(begin), bytes); };
  const replay::Moves moves{part(patches_begin, m.patches_bytes),
                            {part(images_begin, patches->largest_image), part(images_begin + images_step, patches->largest_image)}};
  const Result<replay::Report> report = replay::run(*field, part(trace_begin(), m.replayed_bytes), moves);
  if (!report) return describe(report.error());
  m.numbers[0] = static_cast<double>(report->ticks);
  m.numbers[1] = report->equal ? 1 : 0;
  m.numbers[2] = static_cast<double>(report->first_difference);
  m.replay_hash = report->hash;
  return nullptr;
}
TOUCH_EXPORT(replay_hash) std::uint64_t replay_hash() { return module().replay_hash; }
