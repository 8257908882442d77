/// Touches as sources: where the proxy is, there is a surface, and the hand shows its normal.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/evaluate/touch_points.h"
#include "host/link/controller.h"
#include "host/stream/sources.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::stream {

namespace {

constexpr double kMaxWaitS = 10;  // of ticks: their touches wait while the stream waits for its controller, and take at most some 600 kB
constexpr double kLeastForce = 0.05;  // N, as `isotouch scan`: weaker touches have no direction worth keeping

/// The points of a frame's ticks. Without a touch the hand may rest or be free: then the frame is empty.
class Touches {
 public:
  /// As evaluate::TouchReader.
  ///
  /// room      for that many touches until they are taken
  Touches(const std::string& name, const TickSettings& settings, std::uint64_t room = std::numeric_limits<std::uint64_t>::max())
      : reader_(name, settings, kLeastForce), room_(room) {}

  /// returns   false: it is a touch, and there was no room for it
  bool add(const TraceRecord& record) {
    evaluate::Touch touch;
    if (reader_.read(record, touch) != evaluate::TouchKind::kTouch) return true;
    any_ = true;
    if (model_.positions.size() >= room_) return false;
    model_.positions.push_back(touch.position);
    model_.normals.push_back(touch.normal);
    return true;
  }
  /// As evaluate::TouchReader.
  void set(const TickSettings& settings) { reader_.set(settings); }
  /// fails     InputError: there were touches, and none shows where the surface is
  void require_any() const {
    if (!any_ && reader_.proxyless() > 0) reader_.refuse_proxyless();
  }
  /// They are gone from here.
  Frame frame() {
    return {++number_, [model = std::exchange(model_, {})]() mutable { return std::move(model); }, {}};
  }

 private:
  evaluate::TouchReader reader_;
  cloud::Model model_;
  std::uint64_t room_;
  std::uint64_t number_ = 0;
  bool any_ = false;
};

/// How a running controller feels now.
TickSettings settings_at(link::Controller& controller) {
  RawSettings raw = raw_settings(TickSettings{});
  for (const auto& [name, value] : controller.settings().different) {
    for (std::size_t i = 0; i < kLiveSettings; ++i) {
      if (name == "feel." + std::string(kTickSettingRows[i]->name)) raw[i] = kTickSettingRows[i]->raw(std::strtod(value.c_str(), nullptr));
    }
  }
  return from_raw(raw);
}

/// Ticks of a frame.
std::uint64_t ticks(double rate, std::uint32_t period_ns) {
  return static_cast<std::uint64_t>(std::max(1.0, std::round(1e9 / (rate * std::max(period_ns, 1U)))));
}

}  // namespace

Source recording(std::filesystem::path file, double rate, bool in_time) {
  return [file = std::move(file), rate, in_time](Inbox& inbox) {
    const trace::Trace trace = trace::read_trace(file);
    if (!trace.header().has_outputs)
      throw InputError(file.string() + ": it holds no proxies and forces; record them with isotouch replay, or import them with --forces");
    const std::uint64_t of_frame = ticks(rate, trace.header().period_ns);
    const Clock::time_point begin = Clock::now();
    Touches touches(file.string(), trace.header().settings);
    for (std::size_t tick = 0; tick < trace.size(); ++tick) {
      inbox.hear();
      try {
        (void)touches.add(trace.record(tick));
      } catch (const InputError&) {
        (void)inbox.hand_over(touches.frame());  // those before it are good
        throw;
      }
      const bool is_last = tick + 1 == trace.size();
      if ((tick + 1) % of_frame != 0 && !is_last) continue;
      if (in_time && !inbox.wait_until(
                         begin + std::chrono::nanoseconds((std::int64_t{1} + static_cast<std::int64_t>(tick)) * trace.header().period_ns)))
        return;
      if (in_time && !is_last && !inbox.has_room()) continue;  // no touch comes twice
      if (!(in_time && !is_last ? inbox.offer(touches.frame()) : inbox.hand_over(touches.frame()))) return;
    }
    touches.require_any();
  };
}

Source controller(std::string address, double rate) {
  return [address = std::move(address), rate](Inbox& inbox) {
    using trace_layout::kRecordBytes;
    const auto is_over = [&inbox] { return inbox.is_closed(); };
    link::Controller asked(address, {}, is_over), felt(address, {}, is_over);  // two, because one that is watched answers nothing else
    const std::uint64_t of_frame = ticks(rate, felt.welcome().period_ns);
    Touches touches(address, settings_at(asked), ticks(1 / kMaxWaitS, felt.welcome().period_ns));
    std::uint64_t next = 0;
    std::optional<std::uint64_t> follows;  // the tick that is expected
    bool is_sure = false;                  // every change of the settings was seen
    const auto take = [&](std::uint64_t tick, std::span<const std::uint8_t> bytes) {
      const auto record =
          bytes.size() == kRecordBytes ? decode_record(bytes.first<kRecordBytes>()) : Result<TraceRecord>(Error::kBadRecord);
      if (!record) throw InputError(address + ": a record cannot be read; install the same release on both sides");
      const std::uint64_t lost = follows && tick > *follows ? tick - *follows : 0;
      inbox.hear(lost);
      if (lost > 0) is_sure = false;
      follows = tick + 1;
      if (!touches.add(*record)) inbox.lose(1);
      if (tick < next || !inbox.has_room()) return;  // no touch comes twice, so those of a frame that cannot go yet stay for the next one
      if (!is_sure) touches.set(settings_at(asked));
      is_sure = true;
      next = tick + of_frame;
      (void)inbox.offer(touches.frame());
    };
    const auto hand_over_rest = [&] {
      if (is_sure) (void)inbox.hand_over(touches.frame());
    };
    link::Controller::Watched watched;
    try {
      watched = felt.watch(1, std::numeric_limits<std::uint64_t>::max(), take, is_over);
    } catch (const InputError&) {
      hand_over_rest();
      throw;
    }
    hand_over_rest();
    if (!watched.ended.empty()) throw InputError(watched.ended);
  };
}

}  // namespace isotouch::stream
