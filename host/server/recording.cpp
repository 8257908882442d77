#include "host/server/recording.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/server/put_bytes.h"
#include "host/server/tick_rows.h"
#include "host/server/tick_words.h"
#include "host/trace/hash_text.h"
#include "host/trace/replay.h"
#include "shared/files/state_text.h"
#include "shared/tick_settings.h"

namespace isotouch::server {

namespace {

constexpr std::uint64_t kApart = 50;           ///< ticks without contact after which a contact is another one
constexpr std::uint64_t kPatchesApart = 1000;  ///< the same of patches: a scan that is streamed sends many a second

const std::uint8_t* at(const std::string& rows, std::size_t row, std::size_t column) {
  return reinterpret_cast<const std::uint8_t*>(rows.data()) + row * kRowBytes + 4 * column;
}
float float_at(const std::string& rows, std::size_t row, std::size_t column) {
  return std::bit_cast<float>(load_le<std::uint32_t>(at(rows, row, column)));
}

std::string text_of(const SettingChange& change) {
  const SettingRow& row = *kTickSettingRows[index_of(change.setting)];
  char value[48];
  std::snprintf(value, sizeof value, " = %.6g ", row.value(change.raw));
  return std::string(row.name) + value + std::string(row.unit);
}

}  // namespace

void EventFinder::add(std::uint64_t tick, std::string_view kind, std::string text) {
  if (++counts_[kind] > kMaxOfAKind) {
    more_ = true;
    return;
  }
  events_.push_back({tick, kind, std::move(text)});
}

void EventFinder::look_at(std::uint64_t tick, const TraceRecord& record) {
  const auto& [in, out] = std::pair<const Input&, const Output&>(record.input, record.output);
  if (in.change.setting != TickSetting::kNone) add(tick, "setting", text_of(in.change));
  if ((in.requests & kRequestStop) != 0) add(tick, "stop", "somebody asked for a stop");
  if ((in.requests & kRequestResume) != 0) add(tick, "resume", "somebody resumed");
  if (began_ && in.field_generation != generation_ && (in.requests & kRequestMoved) == 0) add(tick, "field", "another field was loaded");
  if ((in.requests & kRequestMoved) != 0) {
    if (!last_patch_ || tick - *last_patch_ > kPatchesApart) add(tick, "patch", "the surface is patched from here on");
    last_patch_ = tick;
  }
  generation_ = in.field_generation;
  const bool of_device = in.kind == InputKind::kPacket;
  const unsigned fresh_faults = out.faults & ~unsigned{last_.faults};
  if (of_device && (fresh_faults != 0 || !began_ || out.state != last_.state)) {
    const std::string text = files::state_text({out.state, out.faults, out.status, in.field_generation != 0});
    add(tick, fresh_faults != 0 ? "fault" : "state", text);
  }
  if ((out.status & kContact) != 0) {
    if (!touched_ || tick - last_contact_ > kApart) add(tick, "contact", "the hand touches the surface");
    touched_ = true;
    last_contact_ = tick;
  }
  last_ = out;
  began_ = true;
}

Recording::Recording(const trace::Trace& trace, const FieldView* field)
    : name_(std::filesystem::path(trace.path()).filename().string()),
      field_(trace.header().field_hash == 0 ? "" : trace::hash_text(trace.header().field_hash)),
      period_ns_(trace.header().period_ns),
      of_device_(trace.kind() == InputKind::kPacket),
      is_cut_off_(!trace.cut_off().empty()) {
  if (trace.size() == 0) throw InputError(trace.path() + ": it holds no tick; record again");
  std::optional<trace::RecordedPatches> patches;
  std::optional<trace::Run> run;
  if (!trace.header().has_outputs) {
    if (field == nullptr) throw InputError(trace.path() + ": it holds inputs only; name the field that they touch before it");
    patches = trace::read_patches(trace, *field);
    run.emplace(*field, trace.header(), patches ? &*patches : nullptr);
    field_ = trace::hash_text(field->hash());
  }
  rows_.reserve(trace.size() * kRowBytes);
  RowWriter writer;
  EventFinder finder;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    TraceRecord record = trace.record(tick);
    if (run) record = run->step(record.input);
    writer.append(record, rows_);
    if (tick == 0 && trace::begins_patched(trace))
      record.input.requests &= static_cast<std::uint8_t>(~kRequestMoved);  // all of it is of that field
    finder.look_at(tick, record);
  }
  events_ = finder.take();
  more_events_ = finder.found_more();
  is_patched_ = finder.found_patch();
}

std::size_t Recording::ticks() const { return rows_.size() / kRowBytes; }

nlohmann::ordered_json Recording::summary() const {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const Event& event : events_) events.push_back({{"tick", event.tick}, {"kind", event.kind}, {"text", event.text}});
  return {{"name", name_},
          {"ticks", ticks()},
          {"period_ns", period_ns_},
          {"field", field_},
          {"events", std::move(events)},
          {"more_events", more_events_},
          {"is_patched", is_patched_},
          {"is_cut_off", is_cut_off_}};
}

std::string Recording::rows(std::size_t from, std::size_t count) const {
  const std::size_t begin = std::min(from, ticks());
  return rows_.substr(begin * kRowBytes, std::min(count, ticks() - begin) * kRowBytes);
}

nlohmann::ordered_json Recording::words(std::size_t tick) const {
  const std::size_t row = std::min(tick, ticks() - 1);
  const auto whole = [&](std::size_t column) { return load_le<std::uint32_t>(at(rows_, row, kFloatColumns.size() + column)); };
  return to_json(
      words_of({static_cast<std::uint16_t>(whole(1)), static_cast<std::uint16_t>(whole(1) >> 16), whole(0), whole(2) != 0}, of_device_),
      row);
}

std::string Recording::curves(std::size_t from, std::size_t to, std::size_t pieces) const {
  to = std::min(to, ticks());
  from = std::min(from, to);
  const std::size_t length = std::max<std::size_t>(1, (to - from + pieces - 1) / std::max<std::size_t>(1, pieces));
  const std::size_t count = (to - from + length - 1) / length;
  std::string bytes;
  bytes.reserve(12 + 16 * count);
  for (const std::size_t number : {from, length, count}) put_whole(bytes, static_cast<std::uint32_t>(number));
  for (std::size_t begin = from; begin < to; begin += length) {
    float force = 0, depth = 0;
    std::uint32_t status = 0;
    const std::size_t end = std::min(begin + length, to);
    for (std::size_t row = begin; row < end; ++row) {
      force = std::max(force, std::hypot(float_at(rows_, row, 6), float_at(rows_, row, 7), float_at(rows_, row, 8)));
      depth = std::max(depth, float_at(rows_, row, 9));
      status |= load_le<std::uint32_t>(at(rows_, row, kFloatColumns.size()));
    }
    put_float(bytes, static_cast<double>(force));
    put_float(bytes, static_cast<double>(depth));
    put_float(bytes, static_cast<double>(float_at(rows_, end - 1, 10)));
    put_whole(bytes, status);
  }
  return bytes;
}

}  // namespace isotouch::server
