#include "host/trace/fault_response.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "host/error.h"
#include "shared/falcon_packet.h"

namespace isotouch::trace {

namespace {

/// What the inputs show, tick by tick.
class Shown {
 public:
  explicit Shown(const DeviceModel& device) : device_(device) {}

  /// Names joined by '+'; empty where nothing speaks against forces.
  std::string by(const Input& in) {
    std::string names;
    const auto show = [&](bool shown, const char* name) {
      if (shown) names.append(names.empty() ? "" : "+").append(name);
    };
    const auto reply = decode_reply(in.packet);
    const bool heard = in.fresh && reply.has_value();
    if (in.fresh) left_out_ += in.late;
    const std::uint32_t gap = stale_ + 1 + left_out_;  // ticks since the counts that are known
    stale_ = heard ? 0 : std::max(stale_ + 1, std::uint32_t{in.age});
    late_ = {in.late, late_[0], late_[1]};
    const std::int64_t change = heard && known_ ? largest_change(reply->counts) : 0;
    const std::int64_t jump = device_.count_jump;
    const bool unseen = left_out_ >= kMaxLate || (left_out_ > 0 && all_homed_);
    const bool anew = heard && known_ && (unseen || reply->counts == decltype(counts_){} || 8 * change > jump * gap);
    show((in.requests & kRequestStop) != 0, "stop");
    show((in.lines & kLineStop) != 0, "lines");
    show((in.lines & kLineEnableWrong) != 0, "enable");
    show((in.lines & kLineMemory) != 0, "memory");
    show(guard_verdict(in.lines) != GuardVerdict::kNone, "guard");
    show(stale_ >= device_.hold_ticks, "stale");
    show(late_[0] >= device_.hold_ticks || late_[0] + late_[1] + late_[2] > device_.hold_ticks, "late");
    show(anew && reply->homed != kAllHomed, "unhomed");
    show(change > jump * gap, "jump");
    show(gap == 1 && change <= jump && 2 * change > jump, "leap");
    if (heard) counts_ = reply->counts, all_homed_ = reply->homed == kAllHomed, left_out_ = 0;
    known_ |= heard;
    return names;
  }

 private:
  static constexpr std::uint8_t kAllHomed = 7;

  std::int64_t largest_change(const std::array<std::int16_t, 3>& counts) const {
    std::int64_t largest = 0;
    for (std::size_t leg = 0; leg < counts.size(); ++leg) largest = std::max<std::int64_t>(largest, std::abs(counts[leg] - counts_[leg]));
    return largest;
  }

  const DeviceModel& device_;
  std::uint32_t stale_ = 0, left_out_ = 0;
  std::array<std::uint32_t, 3> late_{};
  std::array<std::int16_t, 3> counts_{};  ///< of the last valid packet
  bool known_ = false, all_homed_ = false;
};

}  // namespace

std::vector<FaultResponse> fault_responses(const Trace& trace) {
  if (!trace.header().has_outputs) throw InputError(trace.path() + ": it holds inputs only; replay it with --out first");
  std::vector<FaultResponse> responses;
  Shown shown(trace.header().device);
  bool open = false, any_words = false, words_before = false, quiet_before = false;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    const std::string condition = shown.by(record.input);
    const bool words = record.output.commands != MotorCommands{};
    if (!open && words_before && quiet_before && !condition.empty()) {
      responses.push_back({tick, condition, std::nullopt, SupervisorState::kBoot});
      open = true;
    }
    if (open) responses.back().state = static_cast<SupervisorState>(record.output.state);
    if (open && !words) {
      responses.back().ticks = tick - responses.back().tick;
      open = false;
    }
    any_words |= words;
    words_before = words;
    quiet_before = condition.empty();
  }
  if (!any_words)
    throw InputError(trace.path() + ": no tick has a motor command, so there is nothing to judge; record while the hand feels forces");
  return responses;
}

}  // namespace isotouch::trace
