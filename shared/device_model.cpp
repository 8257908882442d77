#include "shared/device_model.h"

#include <type_traits>

#include "shared/bytes.h"
#include "shared/hash64.h"

namespace isotouch {

namespace {

template <class T>
constexpr auto raw_of(const T& number) {
  if constexpr (std::is_integral_v<T>) {
    return number;
  } else {
    return number.raw();
  }
}

/// Ranges in which no product of the tick overflows and every limit limits.
bool is_valid(const DeviceModel& m) {
  bool valid = true;
  for_each_number(m, [&](const SettingRow* row, const auto& number) {
    if (row != nullptr) valid = valid && raw_range(*row).holds(static_cast<std::int64_t>(raw_of(number)));
  });
  for (const DeviceLeg& leg : m.legs) valid = valid && leg.per_count.raw() != 0;
  return valid && (m.heat_word == 0) == (m.heat_ms == 0);
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
  for_each_number(model, [&](const SettingRow*, const auto& number) {
    store_le(at, raw_of(number));
    at += sizeof(raw_of(number));
  });
  return bytes;
}

Result<DeviceModel> decode_model(const DeviceModelBytes& bytes) {
  DeviceModel model;
  const std::uint8_t* at = bytes.data();
  for_each_number(model, [&](const SettingRow*, auto& number) {
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
