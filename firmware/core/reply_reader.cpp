#include "firmware/core/reply_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace isotouch::core {

namespace {

constexpr std::uint8_t kAllHomed = 0x07;
constexpr std::uint32_t kMaxStale = 1'000'000;  // ticks; beyond every limit
constexpr std::uint32_t kMaxGap = 16;           // ticks for which a hand's way is allowed to add up

/// Did any count change by more than a hand could in `gap` ticks?
bool is_jump(const Counts& from, const Counts& to, std::uint32_t gap, std::int32_t limit) {
  const std::int32_t most = limit * static_cast<std::int32_t>(std::min(gap, kMaxGap));
  bool jump = false;
  for (std::size_t i = 0; i < from.size(); ++i) jump |= std::abs(to[i] - from[i]) > most;
  return jump;
}

}  // namespace

Reading read_reply(const Input& in, const DeviceModel& device, ReplyState& state) {
  const Result<FalconReply> reply = decode_reply(in.packet);
  Reading reading;
  reading.fresh = in.fresh && reply.has_value();
  reading.malformed = in.fresh && !reply.has_value();
  if (in.fresh) state.left_out = std::min(state.left_out + in.late, kMaxStale);
  const std::uint32_t gap = state.stale + 1 + state.left_out;  // ticks since the counts that are known
  state.stale = reading.fresh ? 0 : std::min(std::max(state.stale + 1, std::uint32_t{in.age}), kMaxStale);
  if (!reading.fresh) {
    if (reading.malformed) state.in_a_row = 0;
    return reading;
  }

  reading.jumped = !state.heard || is_jump(state.counts, reply->counts, gap, device.count_jump);
  const bool all_homed = reply->homed == kAllHomed;
  // With the bits went the reference, though the counts were small before, or nobody has seen how they began anew; or one leg has found its mark again.
  const bool unseen = gap > kMaxLate || (state.left_out > 0 && state.all_homed);
  const bool began_anew =
      !all_homed && (unseen || reply->counts == Counts{} || is_jump(state.counts, reply->counts, gap, device.count_jump / 8));
  reading.jumped |= began_anew;
  state.all_homed = all_homed;
  state.in_a_row = all_homed ? std::min<std::uint32_t>(state.in_a_row + 1, 2) : 0;
  if (reading.jumped && !all_homed) state.homed = false;
  if (state.in_a_row == 2) state.homed = true;
  state.left_out = 0;
  state.counts = reply->counts;
  state.buttons = reply->buttons;
  state.heard = true;
  return reading;
}

}  // namespace isotouch::core
