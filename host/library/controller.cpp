#include <unistd.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/field_file/packed.h"
#include "host/files/json_text.h"
#include "host/library/call.h"
#include "host/library/felt.h"
#include "host/library/field.h"
#include "host/library/handles.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "host/trace/trace_file.h"
#include "shared/printable.h"
#include "shared/trace.h"

using namespace isotouch;
using namespace isotouch::library;

namespace {

constexpr std::uint32_t kMaxPatience = 3'600'000;  // ms

/// Every wait has an end, so the ssh to a far controller need not end with Ctrl-C, which a program such as Python catches before it goes on.
bool is_never_over() { return false; }

struct ControllerThing final : Thing {
  ControllerThing(std::string to, int patience_ms)
      : Thing(Kind::kController),
        address(std::move(to)),
        timeout_ms(patience_ms),
        owner(::getpid()),
        connected(std::in_place, address, timeout_ms, is_never_over) {}

  const std::string address;
  const int timeout_ms;
  pid_t owner;                                ///< the process that connected
  std::optional<link::Controller> connected;  ///< none after something failed: an answer may still be on its way

  template <class Request>
  void ask(const Request& request) {
    if (std::exchange(owner, ::getpid()) != ::getpid()) connected.reset();  // a fork's copy would take the answers of the original
    if (!connected) connected.emplace(address, timeout_ms, is_never_over);
    try {
      request(*connected);
    } catch (...) {
      connected.reset();
      throw;
    }
  }
};

/// A connection of its own, so that the other one stays free.
link::Controller another(isotouch_controller controller) {
  const auto [address, timeout_ms] = [&] {
    const Held held(controller, Kind::kController, Use::kShared);
    const auto& known = held.as<ControllerThing>();
    return std::pair(known.address, known.timeout_ms);
  }();
  return link::Controller(address, timeout_ms, is_never_over);
}

/// A request and its answer.
template <class Request>
isotouch_status asked(isotouch_controller controller, const Request& request) {
  return guarded(ISOTOUCH_CONTROLLER, [&] {
    const Held held(controller, Kind::kController, Use::kAlone);
    held.as<ControllerThing>().ask(request);
  });
}

/// The same with arguments that are checked before anything is sent.
template <class Arguments, class Request>
isotouch_status asked(isotouch_controller controller, const Arguments& checked, const Request& request) {
  return guarded(ISOTOUCH_CONTROLLER, [&] {
    const auto arguments = checked();
    const Held held(controller, Kind::kController, Use::kAlone);
    held.as<ControllerThing>().ask([&](link::Controller& with) { request(with, arguments); });
  });
}

/// A text of the protocol: what does not fit is no part of it.
std::string text_of(const char* text, const char* name) {
  std::string whole = required(text, name);
  if (whole.empty() || whole.size() > protocol::kMaxName)
    refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " has " + std::to_string(whole.size()) + " bytes, and must have 1 to " +
                                      std::to_string(protocol::kMaxName) + "; choose another one");
  if (!is_printable(whole)) refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " has control characters or is no UTF-8; choose another one");
  return whole;
}

/// What the file of a recording is refused with is not the controller's fault.
template <class Write>
auto written(const Write& write) {
  try {
    return write();
  } catch (const InputError& error) {
    refuse(ISOTOUCH_BAD_DATA, error.what());
  }
}

TraceRecord record_of(std::span<const std::uint8_t> bytes) {
  using trace_layout::kRecordBytes;
  const auto record = bytes.size() == kRecordBytes ? decode_record(bytes.first<kRecordBytes>()) : Result<TraceRecord>(Error::kBadRecord);
  if (!record) throw InputError("a record of the controller cannot be read; install the same release on both sides");
  return *record;
}

}  // namespace

isotouch_status isotouch_controller_connect(const char* address, uint32_t timeout_ms, isotouch_controller* controller) {
  return guarded(ISOTOUCH_CONTROLLER, [&] {
    const std::string to = required(address, "address");
    required(controller, "controller");
    if (timeout_ms == 0 || timeout_ms > kMaxPatience)
      refuse(ISOTOUCH_BAD_ARGUMENT, "timeout_ms is " + std::to_string(timeout_ms) + ", and must be from 1 to " +
                                        std::to_string(kMaxPatience) + "; 10000 suits most networks");
    *controller = add(std::make_unique<ControllerThing>(to, static_cast<int>(timeout_ms)));
  });
}

isotouch_status isotouch_controller_status(isotouch_controller controller, char* json, size_t capacity, size_t* needed) {
  std::string text;
  const isotouch_status status =
      asked(controller, [&](link::Controller& with) { text = json_text(link::to_json(link::whole_status(with))); });
  return status != ISOTOUCH_OK ? status : guarded(ISOTOUCH_CONTROLLER, [&] { copy_text(text, json, capacity, needed); });
}

isotouch_status isotouch_controller_set(isotouch_controller controller, const char* name, const char* value) {
  return asked(
      controller, [&] { return std::pair(text_of(name, "name"), text_of(value, "value")); },
      [](link::Controller& with, const auto& setting) { with.set(setting.first, setting.second); });
}

isotouch_status isotouch_controller_upload(isotouch_controller controller, isotouch_field field, const char* name) {
  return asked(
      controller, [&] { return text_of(name, "name"); },
      [&](link::Controller& with, const std::string& under) {
        const Held held(field, Kind::kField, Use::kShared);
        const FieldView& view = held.as<FieldThing>().open->view;
        const std::vector<std::uint8_t> packed = field_file::pack(view);  // without its marks, which are for people
        const std::uint64_t hash = view.hash();
        const protocol::Accepted accepted = with.upload({packed.size(), view.image.size(), hash, protocol::Text::of(under)}, packed);
        if (accepted.image_hash != hash) throw InputError("another field was taken over meanwhile; upload again");
      });
}

isotouch_status isotouch_controller_stop(isotouch_controller controller) {
  return asked(controller, [](link::Controller& with) { with.stop(); });
}

isotouch_status isotouch_controller_resume(isotouch_controller controller) {
  return asked(controller, [](link::Controller& with) { with.resume(); });
}

isotouch_status isotouch_controller_watch(isotouch_controller controller, uint32_t every, uint64_t ticks, isotouch_on_tick on_tick,
                                          void* user, uint64_t* lost) {
  return guarded(ISOTOUCH_CONTROLLER, [&] {
    if (lost != nullptr) *lost = 0;
    required(reinterpret_cast<const void*>(on_tick), "on_tick");
    if (every == 0) refuse(ISOTOUCH_BAD_ARGUMENT, "every is 0, and must be 1 or more; 1 is every tick");
    link::Controller with = another(controller);
    bool enough = false;
    const auto show = [&](std::uint64_t tick, std::span<const std::uint8_t> bytes) {
      if (enough) return;
      const isotouch_felt felt = felt_of(tick, record_of(bytes).output);
      enough = on_tick(user, &felt) != 0;
    };
    const link::Controller::Watched watched = with.watch(every, ticks, show, [&] { return enough; });
    if (lost != nullptr) *lost = watched.lost;
    if (!watched.ended.empty()) throw InputError(watched.ended);
  });
}

isotouch_status isotouch_controller_record(isotouch_controller controller, uint64_t ticks, const char* path, isotouch_on_tick on_tick,
                                           void* user, uint64_t* recorded) {
  return guarded(ISOTOUCH_CONTROLLER, [&] {
    if (recorded != nullptr) *recorded = 0;
    const std::string name = file_name(path);
    if (ticks == 0) refuse(ISOTOUCH_BAD_ARGUMENT, "ticks is 0, and must be 1 or more; a second has 1e9 / period_ns of them");
    link::Controller with = another(controller);
    std::optional<trace::TraceWriter> writer;
    std::uint64_t tick = 0;
    bool enough = false;
    const auto keep = [&](std::span<const std::uint8_t> bytes) {
      if (enough) return;
      const TraceRecord record = record_of(bytes);
      writer->append(record);
      if (on_tick == nullptr) return;
      const isotouch_felt felt = felt_of(tick++, record.output);
      enough = on_tick(user, &felt) != 0;
    };
    const std::string ended = with.record(
        ticks,
        [&](std::span<const std::uint8_t> bytes) {
          const Result<TraceHeader> header = decode_header(bytes, bytes.size());
          if (!header) throw InputError("the recording's header cannot be read; install the same release on both sides");
          written([&] { writer.emplace(name, *header, files::Leftover::kRefuse); });
        },
        keep, [&] { return enough || (writer && writer->is_full()); });
    const std::uint64_t kept = written([&] { return writer->finish_with_what_fits().records; });
    if (recorded != nullptr) *recorded = kept;
    if (!ended.empty()) throw InputError(ended + "; " + name + " holds the " + std::to_string(kept) + " ticks before");
    if (kept < ticks && !enough) refuse(ISOTOUCH_BAD_DATA, name + ": the disk is full; free space on it, and record again");
  });
}
