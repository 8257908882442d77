#include "shared/device_model.h"

#include "shared/bytes.h"
#include "shared/hash64.h"

namespace isotouch {

namespace {

/// Walks over the bytes in the order of SPEC.md, writing or reading: one list for both.
template <class Model, class Use>
void for_each_number(Model& m, Use use) {
  use(m.arm), use(m.rod), use(m.joint), use(m.radial), use(m.tangential);
  for (auto& leg : m.legs) use(leg.azimuth), use(leg.per_count), use(leg.at_zero);
  use(m.word_torque);
  use(m.workspace_origin.x), use(m.workspace_origin.y), use(m.workspace_origin.z);
  use(m.word_limit), use(m.word_slew);
  use(m.penetration_limit), use(m.speed_limit);
  use(m.hold_ticks), use(m.fault_age_ns), use(m.count_jump), use(m.ramp_ticks);
  use(m.homing_flag), use(m.led_homing), use(m.led_idle), use(m.led_active);
  use(m.heat_word), use(m.heat_ms), use(m.buttons), use(m.hold_to_run);
}

template <class T>
constexpr auto raw_of(const T& number) {
  if constexpr (std::is_integral_v<T>) {
    return number;
  } else {
    return number.raw();
  }
}

template <class T>
bool is_within(const T& value, const std::type_identity_t<T>& low, const std::type_identity_t<T>& high) {
  return value >= low && value <= high;
}

/// SPEC.md 5.1: ranges in which no product of the tick overflows and every limit limits.
bool is_valid(const DeviceModel& m) {
  bool valid = is_within(m.arm, Mm::of(20), Mm::of(120)) && is_within(m.rod, Mm::of(50), Mm::of(150)) &&
               is_within(m.joint, Mm::of(0), Mm::of(50)) && is_within(m.radial, Mm::of(-60), Mm::of(60)) &&
               is_within(m.tangential, Mm::of(-30), Mm::of(30));
  for (const DeviceLeg& leg : m.legs) valid &= leg.per_count.raw() != 0;
  valid &= is_within(m.word_torque, NewtonMmPerWord::of(0.01), NewtonMmPerWord::of(1));
  for (const Mm axis : {m.workspace_origin.x, m.workspace_origin.y, m.workspace_origin.z})
    valid &= is_within(axis, Mm::of(-300), Mm::of(300));
  valid &= is_within(m.word_limit, 0, 4095) && is_within(m.word_slew, 1'000, 100'000'000);
  valid &= is_within(m.penetration_limit, Mm::of(0.1), Mm::of(200)) && is_within(m.speed_limit, MmPerS::of(1), MmPerS::of(100'000));
  valid &= is_within(m.hold_ticks, 1U, 1000U) && is_within(m.fault_age_ns, 1'000'000U, 1'000'000'000U);
  valid &= is_within(m.count_jump, 10, 4000) && is_within(m.ramp_ticks, 1U, 100'000U);
  for (const std::uint8_t flags : {m.homing_flag, m.led_homing, m.led_idle, m.led_active, m.buttons}) valid &= flags <= 0x0F;
  const bool heat_unwatched = m.heat_word == 0 && m.heat_ms == 0;  // version 2.0 of the trace knew none
  valid &= heat_unwatched || (is_within(m.heat_word, 1, 4095) && is_within(m.heat_ms, 1'000U, 1'000'000U));
  valid &= m.hold_to_run <= 1;
  return valid;
}

constexpr DeviceLeg leg(Angle azimuth, AnglePerCount per_count, Angle at_zero) { return {azimuth, per_count, at_zero}; }

}  // namespace

DeviceModel libnifalcon_model() {
  constexpr AnglePerCount kPerCount = AnglePerCount::degrees(0.0364346591);  // 1280 counts a turn of the motor, 110 / 14.25 turns an arm's
  constexpr Angle kAtZero = Angle::degrees(35);
  DeviceModel model;
  model.arm = Mm::of(60);
  model.rod = Mm::of(102.5);
  model.joint = Mm::of(22.5);
  model.radial = Mm::of(14.43 - 40.0);
  model.tangential = Mm::of(-25.0 + 23.09);
  model.legs = {leg(Angle::degrees(105), kPerCount, kAtZero), leg(Angle::degrees(-15), kPerCount, kAtZero),
                leg(Angle::degrees(-135), kPerCount, kAtZero)};
  model.word_torque = NewtonMmPerWord::of(0.1);
  return model;
}

DeviceModel martin_hillier_model() {
  constexpr AnglePerCount kPerCount = AnglePerCount::degrees(360.0 / 1280.0 / 7.62);
  constexpr Angle kAtZero = Angle::degrees(40);
  DeviceModel model;
  model.arm = Mm::of(60);
  model.rod = Mm::of(102.5);
  model.joint = Mm::of(23);
  model.radial = Mm::of(15.7 - 36.6);
  model.tangential = Mm::of(27.2 - 26.2);
  model.legs = {leg(Angle::degrees(105), kPerCount, kAtZero), leg(Angle::degrees(-15), kPerCount, kAtZero),
                leg(Angle::degrees(-135), kPerCount, kAtZero)};
  model.word_torque = NewtonMmPerWord::of(0.15114);
  return model;
}

DeviceModelBytes encode(const DeviceModel& model) {
  DeviceModelBytes bytes{};
  std::uint8_t* at = bytes.data();
  for_each_number(model, [&](const auto& number) {
    store_le(at, raw_of(number));
    at += sizeof(raw_of(number));
  });
  return bytes;
}

Result<DeviceModel> decode_model(const DeviceModelBytes& bytes) {
  DeviceModel model;
  const std::uint8_t* at = bytes.data();
  for_each_number(model, [&](auto& number) {
    using T = std::remove_reference_t<decltype(number)>;
    using Raw = decltype(raw_of(number));
    if constexpr (std::is_integral_v<T>) {
      number = load_le<Raw>(at);
    } else {
      number = T::from_raw(load_le<Raw>(at));
    }
    at += sizeof(Raw);
  });
  if (!is_valid(model) || encode(model) != bytes) return Error::kBadModel;
  return model;
}

std::uint64_t hash(const DeviceModel& model) {
  const DeviceModelBytes bytes = encode(model);
  return hash64(bytes.data(), bytes.size());
}

}  // namespace isotouch
