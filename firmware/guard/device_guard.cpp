#include "firmware/guard/device_guard.h"

#include <cstdlib>

namespace isotouch::guard {

DeviceGuard::DeviceGuard(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns, loop::FieldSlots& fields,
                         const loop::Requests& requests, loop::LineState& lines)
    : constants_{Guard(device, period_ns), settings}, fields_(fields), requests_(requests), lines_(lines) {
  if (is_ready()) static_cast<void>(put(afresh()));
  fields.expect_guard();
}

MotorCommands DeviceGuard::pass(const loop::Command& command, std::int64_t now_ns) {
  if (!is_ready()) return {};
  Memory memory = *memory_.get();
  if (!seal_.holds(*memory_.get())) {
    memory = afresh();
    memory.verdict = GuardVerdict::kMemory;
    memory.verdict_tick = command.tick;
    memory.replies = command.sample;  // the numbers of the samples go on
  }
  for (std::size_t i = 0; i < kLiveSettings; ++i) {
    std::int32_t& largest = memory.largest[i];
    const std::int32_t now = requests_.newest(static_cast<TickSetting>(i + 1), largest);
    if (std::abs(now) > std::abs(largest)) largest = now;
  }
  const loop::ActiveField field = fields_.field_of(command.field_generation);
  const Evidence evidence{now_ns,
                          lines_.lines(),
                          requests_.stops(),
                          requests_.is_stopped(),
                          field.view,
                          field.surface,
                          with_live(constants_.settings, memory.largest)};
  MotorCommands passes = constants_.guard.judge(command, evidence, memory);
  if (!put(memory)) passes = {};
  lines_.put(memory.verdict);
  return passes;
}

void DeviceGuard::hear(const FalconPacket& packet, std::int64_t now_ns) {
  if (!is_ready() || !seal_.holds(*memory_.get())) return;  // the next command is told
  Memory memory = *memory_.get();
  constants_.guard.hear(packet, now_ns, memory);
  static_cast<void>(put(memory));  // without it the next command meets old packets, and is stopped when they are too old
}

bool DeviceGuard::put(const Memory& memory) {
  if (!memory_.put(memory)) return false;
  seal_.close(*memory_.get());
  return true;
}

Memory DeviceGuard::afresh() const {
  Memory memory;
  memory.largest = live_settings(constants_.settings);
  return memory;
}

}  // namespace isotouch::guard
