#include "host/server/controller_feed.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/files/json_text.h"
#include "host/server/put_bytes.h"
#include "host/server/tick_rows.h"
#include "host/server/tick_words.h"
#include "shared/trace.h"

namespace isotouch::server {

namespace {

constexpr double kRowsASecond = 1000;  ///< at most: of a faster controller every second, third, … tick
constexpr auto kBatch = std::chrono::milliseconds(16);
constexpr int kAgain_ms = 500;
constexpr int kLook_ms = 250;      ///< from one look for another field to the next
constexpr int kLooksAMeasure = 4;  ///< whoever reads measures needs no more
constexpr int kNice = 10;

/// Rows of ticks that follow one another.
class Batch {
 public:
  explicit Batch(std::uint32_t every) : every_(every) {}

  bool empty() const { return rows_ == 0; }
  bool continues_with(std::uint64_t tick) const { return tick == next_; }
  bool is_old() const { return !empty() && std::chrono::steady_clock::now() - began_ >= kBatch; }
  void add(std::uint64_t tick, const TraceRecord& record) {
    if (empty()) first_ = tick, began_ = std::chrono::steady_clock::now();
    if (!continues_with(tick)) writer_.gap();
    next_ = tick + every_;
    writer_.append(record, bytes_);
    ++rows_;
  }
  /// first tick (8 bytes), ticks from row to row, rows (4 bytes each), then the rows
  std::string take() {
    std::string message;
    message.reserve(16 + bytes_.size());
    put_whole(message, first_);
    put_whole(message, every_);
    put_whole(message, rows_);
    message += bytes_;
    bytes_.clear();
    rows_ = 0;
    return message;
  }

 private:
  std::uint32_t every_;
  std::uint64_t first_ = 0, next_ = 0;
  std::uint32_t rows_ = 0;
  std::chrono::steady_clock::time_point began_;
  std::string bytes_;
  RowWriter writer_;
};

}  // namespace

ControllerFeed::ControllerFeed(std::string address, Send send, Describe describe, Field field)
    : address_(std::move(address)),
      send_(std::move(send)),
      describe_(std::move(describe)),
      field_(std::move(field)),
      measures_([this](const std::stop_token& stop) { measure(stop); }),
      follows_([this](const std::stop_token& stop) { follow(stop); }) {}

std::vector<Shared> ControllerFeed::newest() const {
  const std::scoped_lock held(lock_);
  std::vector<Shared> all;
  std::copy_if(newest_.begin(), newest_.end(), std::back_inserter(all), [](const Shared& message) { return message != nullptr; });
  return all;
}

/// What comes late of a controller that is gone, or before the next one is told of, is left out.
void ControllerFeed::tell(Topic topic, const nlohmann::ordered_json& json) {
  auto message = std::make_shared<const Message>(Message{topic, false, json_text(json)});
  const std::scoped_lock held(lock_);
  if (topic == Topic::kLink) {
    is_there_ = json["there"];
    newest_ = {};
  }
  if (topic != Topic::kLink && !is_there_) return;
  newest_[static_cast<std::size_t>(topic)] = message;
  send_(std::move(message));  // in the order of what is told
}

bool ControllerFeed::wait(const std::stop_token& stop, int ms) {
  std::mutex lock;
  std::condition_variable_any woken;
  std::unique_lock held(lock);
  woken.wait_for(held, stop, std::chrono::milliseconds(ms), [] { return false; });
  return !stop.stop_requested();
}

void ControllerFeed::follow(const std::stop_token& stop) {
  std::string last;
  do {
    std::string why;
    try {
      follow_once(stop);
    } catch (const std::exception& error) {
      why = error.what();
    }
    if (stop.stop_requested()) return;
    if (is_there_ || why != last)
      tell(Topic::kLink, {{"topic", "link"}, {"there", false}, {"sentence", why + "; the page tries again by itself"}});
    last = why;
  } while (wait(stop, kAgain_ms));
}

/// fails     InputError: why it ended, always but when this object ends
void ControllerFeed::follow_once(const std::stop_token& stop) {
  standing_ = 0;
  others_ = protocol::OtherAngles::kNone;
  link::Controller controller(address_, {}, [&] { return stop.stop_requested(); });
  const double ticks_a_second = 1e9 / std::max(controller.welcome().period_ns, 1U);
  const auto every = static_cast<std::uint32_t>(std::max(1.0, std::round(ticks_a_second / kRowsASecond)));
  tell(Topic::kLink, {{"topic", "link"},
                      {"there", true},
                      {"sentence", address_ + ": " + std::string(controller.welcome().program.view()) + " answers"},
                      {"period_ns", controller.welcome().period_ns},
                      {"every", every}});
  Batch batch(every);
  std::optional<TickWords> words, told;
  std::uint64_t last_tick = 0;
  const auto flush = [&] {
    if (batch.empty()) return;
    send_(std::make_shared<const Message>(Message{Topic::kTicks, true, batch.take()}));
    if (told != words) tell(Topic::kState, to_json(*words, last_tick));
    told = words;
  };
  const auto take = [&](std::uint64_t tick, std::span<const std::uint8_t> bytes) {
    using trace_layout::kRecordBytes;
    const auto record = bytes.size() == kRecordBytes ? decode_record(bytes.first<kRecordBytes>()) : Result<TraceRecord>(Error::kBadRecord);
    if (!record) throw InputError(address_ + ": a record cannot be read; install the same release on both sides");
    if (!batch.continues_with(tick)) flush();
    batch.add(tick, *record);
    const Output& out = record->output;
    if (out.faults == 0) standing_ = 0;  // those of before are over
    const auto faults = static_cast<std::uint16_t>(out.faults != 0 ? out.faults | standing_ : 0);
    words =
        words_of({out.state, faults, out.status, record->input.field_generation != 0}, record->input.kind == InputKind::kPacket, others_);
    last_tick = tick;
    if (batch.is_old()) flush();
  };
  const auto [lost, ended] = controller.watch(
      every, UINT64_MAX, take, [&] { return stop.stop_requested(); }, flush);
  if (!stop.stop_requested()) throw InputError(ended);
}

void ControllerFeed::measure(const std::stop_token& stop) {
  (void)::setpriority(PRIO_PROCESS, 0, kNice);  // of this thread: a surface may take a while, and the ticks and pictures come first
  while (wait(stop, kAgain_ms)) {
    try {
      link::Controller controller(address_, {}, [&] { return stop.stop_requested(); });
      int looks = 0;
      do {
        if (looks++ % kLooksAMeasure == 0) tell_measures(controller);
        take_field(controller);
      } while (wait(stop, kLook_ms));
    } catch (const std::exception&) {  // `follow` says so
    }
  }
}

void ControllerFeed::tell_measures(link::Controller& controller) {
  nlohmann::ordered_json json{{"topic", "status"}, {"status", describe_(controller)}};
  for (const auto& [key, measure] : {std::pair("wakeup", protocol::Measure::kWakeup), std::pair("tick", protocol::Measure::kTick)}) {
    nlohmann::ordered_json bins = nlohmann::ordered_json::array();
    for (const protocol::Bin& bin : controller.histogram(measure).bins) bins.push_back({bin.upper / 1000.0, bin.count});
    json["histograms_us"][key] = std::move(bins);
  }
  if (unusable_ != 0 && field_.wanted(unusable_)) json["field_sentence"] = why_unusable_;
  tell(Topic::kStatus, json);
}

void ControllerFeed::take_field(link::Controller& controller) {
  const protocol::StatusReport status = controller.status();
  standing_ = status.faults;
  others_ = static_cast<protocol::OtherAngles>(controller.device().waits);
  if (status.field_hash != unusable_) unusable_ = 0;
  if (status.field_hash == 0 || unusable_ != 0 || !field_.wanted(status.field_hash)) return;
  const link::Controller::Image image = controller.image();
  try {
    field_.taken(std::string(status.field_name.view()), image);
  } catch (const InputError& error) {  // the same bytes would be refused again
    unusable_ = image.hash;
    why_unusable_ = error.what();
  }
}

}  // namespace isotouch::server
