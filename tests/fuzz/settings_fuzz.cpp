/// The door for settings: a file is refused with a sentence, or its settings make a device.
#include <string>
#include <string_view>

#include "firmware/settings/apply.h"
#include "firmware/settings/read_settings.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  settings::Settings read;
  if (const Refusal refusal = settings::parse_settings(text, "a.toml", read)) return 0;
  const std::uint32_t period = settings::period_ns(read);
  fuzz::hold(period >= 100'000 && period <= 4'000'000, "a period is in range");
  static_cast<void>(settings::tick_settings(read));
  const Result<DeviceModel> device = settings::device_model(read, "A");
  if (device) {
    const Result<DeviceModel> again = decode_model(encode(*device));
    fuzz::hold(again && hash(*again) == hash(*device), "a device of settings is one that a recording may name");
  }
  return 0;
}
