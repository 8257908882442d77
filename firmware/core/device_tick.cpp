#include "firmware/core/device_tick.h"

namespace isotouch::core {

DeviceTickModel make_device_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns) {
  return {device, settings, period_ns};
}

DeviceOutput device_tick(const DeviceInput& /*in*/, const BlobView* /*field*/, const DeviceTickModel& model, DeviceState& /*state*/) {
  DeviceOutput out;
  out.packet_flags = static_cast<std::uint8_t>(model.device.homing_flag | model.device.led_homing);
  return out;
}

}  // namespace isotouch::core
