/// The guard where it works: on the thread that talks to the device. No other thread can write what it remembers, and a hash of that is checked before
/// each use. Its model and settings are ordinary memory, which `loop::MemoryCheck` checks. What it finds stops the force at once, and reaches the tick
/// beside the safety lines, so that the supervisor is in fault and the recording names it.
#pragma once

#include <span>

#include "firmware/guard/guard.h"
#include "firmware/guard/private_memory.h"
#include "firmware/loop/field_slots.h"
#include "firmware/loop/line_state.h"
#include "firmware/loop/requests.h"
#include "firmware/loop/seal.h"

namespace isotouch::guard {

class DeviceGuard final : public loop::CommandGuard {
 public:
  /// settings  at the start
  /// fields, requests, lines   live longer
  DeviceGuard(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns, loop::FieldSlots& fields,
              const loop::Requests& requests, loop::LineState& lines);

  /// false: the system has no memory for it, and no force passes.
  bool is_ready() const { return memory_.get() != nullptr; }

  /// What does not change while it judges, as it stands in memory; for `loop::MemoryCheck`.
  std::span<const std::uint8_t> constants() const { return {reinterpret_cast<const std::uint8_t*>(&constants_), sizeof constants_}; }

  MotorCommands pass(const loop::Command& command, std::int64_t now_ns) override;
  void hear(const FalconPacket& packet, std::int64_t now_ns) override;

 private:
  struct Constants {
    Guard guard;
    TickSettings settings;
  };

  bool put(const Memory& memory);
  Memory afresh() const;

  const Constants constants_;
  loop::FieldSlots& fields_;
  const loop::Requests& requests_;
  loop::LineState& lines_;
  PrivateMemory<Memory> memory_;
  loop::Seal seal_;
};

}  // namespace isotouch::guard
