/// The core under anything that a device may send: bounds hold, and the same inputs give the same commands.
#include <cstdlib>

#include "firmware/core/tick.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

const FieldView& ball() {
  static const test::FieldImage image({64, 64, 64},
                                      [](const test::Point& p) {
                                        return length(p - test::Point{32, 32, 32}) - 20;
                                      },
                                      {.origin_mm = {-10.9, -10.9, -10.9}});
  return image.view();
}

/// A hand that mostly moves as hands do, a device that mostly answers.
struct Wire {
  FalconReply reply{{0, 0, 0}, 0, 7};
  Input in;

  Input& next(fuzz::Front& front) {
    const auto what = front.take<std::uint8_t>();
    in.fresh = true;
    in.age = 0;
    in.requests = in.late = in.lines = 0;
    in.change = {};
    in.field_generation = 1;
    const int reach = (what & 0x80U) != 0 ? 8 : 1;
    for (std::int16_t& count : reply.counts) {
      count = static_cast<std::int16_t>(static_cast<std::uint16_t>(count + reach * front.take<std::int8_t>() / 8));
    }
    in.packet = encode(reply);
    switch (what & 0x0FU) {
      case 0:
        for (std::uint8_t& byte : in.packet) byte = front.take<std::uint8_t>();
        break;
      case 1: in.fresh = false, in.age = front.take<std::uint8_t>(); break;
      case 2: in.requests = front.take<std::uint8_t>() & 7U; break;
      case 3: in.lines = front.take<std::uint8_t>() & 0xF7U; break;
      case 4: in.late = front.take<std::uint8_t>() & 31U; break;
      case 5: {
        const SettingChange change{static_cast<TickSetting>(front.take<std::uint8_t>() & 15U), front.take<std::int32_t>()};
        if (is_valid(change)) in.change = change;
        break;
      }
      case 6: in.field_generation = front.take<std::uint8_t>() & 1U; break;
      case 7:
        for (std::int16_t& count : reply.counts) count = front.take<std::int16_t>();
        break;
      case 8: reply.homed = front.take<std::uint8_t>() & 7U; break;
      case 9: reply.buttons = front.take<std::uint8_t>() & 15U; break;
      default: break;
    }
    return in;
  }
};

DeviceModel model_of(fuzz::Front& front) {
  const auto which = front.take<std::uint8_t>();
  DeviceModel model = which % 2 == 0 ? libnifalcon_model() : martin_hillier_model();
  if (which % 4 < 2) return model;
  DeviceModelBytes bytes = encode(model);  // some of its numbers are others
  for (int i = 0; i < 4; ++i) bytes[front.take<std::uint8_t>() % bytes.size()] = front.take<std::uint8_t>();
  const Result<DeviceModel> changed = decode_model(bytes);
  return changed ? *changed : model;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Front front(data, size);
  TickSettings settings;
  const auto feel = front.take<std::uint8_t>();
  if ((feel & 1U) != 0) settings.friction = Ratio::of(0.5);
  if ((feel & 2U) != 0) settings.hand_damping = Damping::of(0.004);
  if ((feel & 4U) != 0) settings.passivity = Damping::of(0.01), settings.device_damping = Damping::of(0.003), settings.delay_ticks = 2;
  if ((feel & 8U) != 0) settings.weight = Newton::of(0.8);
  if ((feel & 16U) != 0) settings.damping = Damping::of(0.001);
  const core::TickModel model = core::make_tick_model(model_of(front), settings, 1'000'000);

  core::TickState state, twin;
  Wire wire;
  for (int tick = 0; tick < 1000 && !front.empty(); ++tick) {
    const Input& in = wire.next(front);
    const FieldView* field = in.field_generation == 0 ? nullptr : &ball();
    const Output out = core::tick(in, field, model, state);
    fuzz::hold(out == core::tick(in, field, model, twin), "the same inputs give the same outputs");
    fuzz::hold(out.state <= static_cast<std::uint16_t>(SupervisorState::kFault), "the supervisor is in one of its states");
    const bool active = out.state == static_cast<std::uint16_t>(SupervisorState::kActive);
    for (const std::int16_t word : out.commands) {
      fuzz::hold(active || word == 0, "words are zero in every state but active");
      fuzz::hold(std::abs(word) <= model.device.word_limit, "no word is beyond the limit");
    }
    fuzz::hold((out.faults != 0) == (out.state == static_cast<std::uint16_t>(SupervisorState::kFault)), "a fault has its reasons");
  }
  return 0;
}
