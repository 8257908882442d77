#include "firmware/guard/device_guard.h"

#include <cstdlib>

namespace isotouch::guard {

DeviceGuard::DeviceGuard(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns, loop::FieldSlots& fields,
                         const loop::Requests& requests, loop::LineState& lines)
    : guard_(device, period_ns),
      largest_(live_settings(settings)),
      settings_(settings),
      fields_(fields),
      requests_(requests),
      lines_(lines) {
  fields.expect_guard();
}

MotorCommands DeviceGuard::pass(const loop::Command& command, std::int64_t now_ns) {
  if (!is_ready()) return {};
  for (std::size_t i = 0; i < kLiveSettings; ++i) {
    const std::int32_t now = requests_.newest(static_cast<TickSetting>(i + 1), largest_[i]);
    if (std::abs(now) > std::abs(largest_[i])) largest_[i] = now;
  }
  const Evidence evidence{now_ns,
                          lines_.lines(),
                          requests_.stops(),
                          requests_.is_stopped(),
                          fields_.field_of(command.field_generation),
                          with_live(settings_, largest_)};
  Memory memory = *memory_.get();
  MotorCommands passes = guard_.judge(command, evidence, memory);
  if (!memory_.put(memory)) passes = {};
  lines_.put(memory.verdict);
  return passes;
}

void DeviceGuard::hear(const FalconPacket& packet, std::int64_t now_ns) {
  if (!is_ready()) return;
  Memory memory = *memory_.get();
  guard_.hear(packet, now_ns, memory);
  static_cast<void>(memory_.put(memory));  // without it the next command meets old packets, and is stopped when they are too old
}

}  // namespace isotouch::guard
