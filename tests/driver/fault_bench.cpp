#include "tests/driver/fault_bench.h"

#include <algorithm>
#include <span>
#include <sstream>

#include "firmware/loop/realtime.h"
#include "tests/support/field_image.h"

namespace isotouch::test {

namespace {

constexpr std::int64_t kRefreshNs = 2'500'000, kSilentNs = 4 * FaultBench::kPeriod,
                       kCheckNs = 100'000'000;  // as the daemon sets them at 1 kHz

falcon_model::Settings model_settings(const FaultBench::Options& options) {
  falcon_model::Settings settings;
  settings.path = options.path;
  std::istringstream script(options.faults);
  settings.faults = falcon_model::read_faults(script, "the script");
  return settings;
}

double smooth(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

std::vector<std::uint8_t> ball_image(double radius_mm) {
  return FieldImage({106, 106, 106},
                    [radius_mm](const Point& p) {
                      return (length(p * 0.7 - Point{37.1, 37.1, 37.1}) - radius_mm) / 0.7;
                    },
                    {.edge_mm = 0.7, .origin_mm = {-37.1, -37.1, -37.1}})
      .bytes();
}

falcon_model::Path pressing_hand() {
  return [](double ms) {
    const double tremor =
        0.2 * (smooth(std::min(ms / 50 - 2 * static_cast<int>(ms / 100), 2 - ms / 50 + 2 * static_cast<int>(ms / 100))) - 0.5);
    return falcon_model::Vector{tremor, 0, 45 - 27 * smooth(ms / 1000)};
  };
}

FaultBench::FaultBench(const Options& options)
    : link(model_settings(options), link_clock),
      session(link, link_clock, firmware),
      port(session, link),
      watch({}, lines, clock, line_state, stats.ticks),
      settings{options.device, options.tick, static_cast<std::uint32_t>(kPeriod), false},
      guard(options.device, settings.tick, static_cast<std::uint32_t>(kPeriod), fields, commands, line_state),
      loop(settings, *this, clock, {fields, commands, trace, shown, stats, &line_state}),
      memory_check(fields, {loop.constants(), guard.constants()}) {
  lines.sleeps = false;
  gap_began_ = clock.passed;
}

const loop::TickRecord& FaultBench::tick() {
  watch.step();
  if (clock.passed - checked_ >= kCheckNs) {
    checked_ = clock.passed;
    line_state.put_damaged(memory_check.step() != loop::Damage::kNone);
  }
  loop.step();
  last = shown.get();
  longest_gap_ns = std::max(longest_gap_ns, clock.passed - gap_began_);
  gap_began_ = clock.passed;
  return last;
}

bool FaultBench::load(const std::vector<std::uint8_t>& image) {
  const std::span<std::uint8_t> room = fields.begin(image.size());
  if (room.size() < image.size()) return false;
  std::copy(image.begin(), image.end(), room.begin());
  return fields.verify().has_value() && fields.commit().has_value();
}

bool FaultBench::begin() {
  load(ball_image(25));
  for (int t = 0, steady = 0; t < 30'000; ++t) {
    tick();
    for (loop::TickRecord record; trace.pop(record);) {
    }
    steady = has_words() && (last.out.status & kRamping) == 0 ? steady + 1 : 0;
    if (steady == 1500) {
      longest_gap_ns = 0;
      return true;
    }
  }
  return false;
}

loop::Wake FaultBench::wait(std::int64_t until_ns) {
  clock.now -= set_back_ns;
  ends_ns_ -= set_back_ns;
  ticked_ns_ -= set_back_ns;
  sent_ns_ -= set_back_ns;
  set_back_ns = 0;
  while (!unseen_) {
    if (!busy_) begin_exchange();
    if (ends_ns_ > until_ns) {
      clock.sleep_until_ns(until_ns);
      break;
    }
    clock.sleep_until_ns(ends_ns_);
    end_exchange();
  }
  if (late_ns > 0) pass_without_ticks(clock.now + late_ns);
  late_ns = 0;
  return unseen_ ? loop::Wake::kReply : loop::Wake::kDue;
}

loop::Sample FaultBench::newest() {
  unseen_ = false;
  if (garble) garble(sample_);
  return sample_;
}

void FaultBench::leave(const loop::Command& command) {
  command_ = command;
  if (tamper) tamper(command_);
  ticked_ns_ = clock.now;
  if (!busy_) begin_exchange();
}

/// What the exchange thread does until the next reply: its time is the link's.
void FaultBench::begin_exchange() {
  loop::Command command = command_;
  if (clock.now - ticked_ns_ > kSilentNs) command.falcon.words = {};
  link_clock.now = sent_ns_ = clock.now;
  const std::uint64_t allocated = loop::allocations_of_thread;
  command.falcon.words = judge->pass(command, clock.now);
  sent = command.falcon;
  packets_with_force += is_zero(sent.words) ? 0U : 1U;
  const loop::Answer answer = port.exchange(command.falcon, arriving_);
  allocations_of_driver += loop::allocations_of_thread - allocated;
  replies_ = answer == loop::Answer::kReply;
  ends_ns_ = sent_ns_ + std::max(link_clock.now - sent_ns_, kPeriod);
  busy_ = true;
}

bool FaultBench::end_exchange() {
  busy_ = false;
  if (!replies_) return false;
  judge->hear(arriving_, ends_ns_);
  arrived_ = sample_ = {arriving_, arrived_.number + 1, sent_ns_, ends_ns_, -1};
  return unseen_ = true;
}

/// Nobody answers a reply with commands: the device is asked again all the same, with the last ones for a while.
void FaultBench::pass_without_ticks(std::int64_t until_ns) {
  while (busy_ ? ends_ns_ <= until_ns : clock.now + kRefreshNs <= until_ns) {
    clock.sleep_until_ns(busy_ ? ends_ns_ : sent_ns_ + kRefreshNs);
    if (busy_) {
      end_exchange();
    } else {
      begin_exchange();
    }
  }
  clock.sleep_until_ns(until_ns);
}

}  // namespace isotouch::test
