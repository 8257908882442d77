#include "firmware/store/calibration_store.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <span>
#include <string_view>

#include "firmware/store/whole_file.h"
#include "shared/bytes.h"
#include "shared/crc32.h"

namespace isotouch::store {

namespace {

constexpr std::size_t kDigits = 8, kNumbers = 4, kFileBytes = kNumbers * (kDigits + 1);
constexpr std::size_t kMaxSerial = 24;

std::string file_of(const std::string& serial) { return "calibration-" + serial; }

std::uint32_t checksum(const AnglesAtZero& angles) {
  std::array<std::uint8_t, 12> bytes{};
  for (std::size_t i = 0; i < angles.size(); ++i) store_le(&bytes[4 * i], angles[i].raw());
  return crc32(bytes.data(), bytes.size());
}

void append(std::string& text, std::uint32_t value, char end) {
  for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15U];
  text += end;
}

}  // namespace

StoreResult<AnglesAtZero> CalibrationStore::read(const std::string& serial) const {
  if (!is_serial(serial)) return StoreError::kNotFound;
  std::array<std::uint8_t, kFileBytes> bytes{};
  const StoreResult<std::size_t> got = folder_.read(file_of(serial), bytes);
  if (!got) return got.error() == StoreError::kTooLarge ? StoreError::kDamaged : got.error();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), *got);
  std::array<std::uint32_t, kNumbers> numbers{};
  bool good = text.size() == kFileBytes;
  for (std::size_t i = 0; good && i < kNumbers; ++i) {
    const char* begin = text.data() + i * (kDigits + 1);
    const auto [end, failed] = std::from_chars(begin, begin + kDigits, numbers[i], 16);
    good = failed == std::errc{} && end == begin + kDigits && *end == (i + 1 < kNumbers ? ' ' : '\n');
  }
  const AnglesAtZero angles = {Angle::from_raw(numbers[0]), Angle::from_raw(numbers[1]), Angle::from_raw(numbers[2])};
  if (!good || numbers[3] != checksum(angles)) return StoreError::kDamaged;
  return angles;
}

StoreResult<void> CalibrationStore::put(const std::string& serial, const AnglesAtZero& angles) {
  if (!is_serial(serial)) return StoreError::kNotAllowed;
  std::string text;
  for (const Angle angle : angles) append(text, angle.raw(), ' ');
  append(text, checksum(angles), '\n');
  return write_whole(folder_, "calibration.part", file_of(serial), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

bool CalibrationStore::is_serial(const std::string& serial) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return !serial.empty() && serial.size() <= kMaxSerial && std::all_of(serial.begin(), serial.end(), plain);
}

}  // namespace isotouch::store
