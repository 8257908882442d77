#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "hil/falcon_model/paths.h"

namespace isotouch::falcon_model {

namespace {

// Trace, version 3: shared/SPEC.md, section 3.
constexpr std::size_t kHeaderBytes = 256, kRecordBytes = 104, kMajorAt = 4, kCountAt = 16, kPeriodAt = 36, kChecksumAt = 252;
constexpr std::size_t kPlaceAt = 16;  // of a record, which begins with its kind
constexpr std::uint64_t kMajor = 3, kPosition = 0;
constexpr double kMmPerUnit = 1.0 / (1 << 20);

using File = std::vector<unsigned char>;

std::uint64_t number(const File& file, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | file[at + i];
  return value;
}

/// CRC-32 of IEEE 802.3, bit by bit.
std::uint32_t checksum(const File& file, std::size_t size) {
  std::uint32_t state = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < size; ++i) {
    state ^= file[i];
    for (int bit = 0; bit < 8; ++bit) state = state >> 1 ^ ((state & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~state;
}

double millimetres(const File& file, std::size_t at) { return kMmPerUnit * static_cast<std::int32_t>(number(file, at, 4)); }

void check(const File& file, const std::string& name) {
  const auto refuse = [&](const std::string& why) { throw std::runtime_error(name + ": " + why); };
  const std::array<unsigned char, 4> magic = {'I', 'T', 'R', 'C'};
  if (file.size() < kHeaderBytes || !std::equal(magic.begin(), magic.end(), file.begin()))
    refuse("is no trace; make one with isotouch trace make");
  if (number(file, kMajorAt, 2) != kMajor) refuse("is a trace of another version; make it with this release of isotouch");
  if (number(file, kChecksumAt, 4) != checksum(file, kChecksumAt))
    refuse("the header's checksum is wrong; the file is damaged, make it again");
  const std::uint64_t count = number(file, kCountAt, 8);
  if (count == 0) refuse("holds no tick; make it again");
  if (number(file, 8, 4) != kHeaderBytes || number(file, 12, 4) != kRecordBytes || count > (file.size() - kHeaderBytes) / kRecordBytes) {
    refuse("is shorter than its header says; the file is damaged, make it again");
  }
  if (number(file, kHeaderBytes, 1) != kPosition) refuse("holds packets of a device; a hand follows a trace of positions");
  if (number(file, kPeriodAt, 4) == 0) refuse("has a tick period of zero; make it again");
}

}  // namespace

Path recorded_path(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
  const File file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  check(file, path.string());
  const auto count = static_cast<std::size_t>(number(file, kCountAt, 8));
  const double period_ms = static_cast<double>(number(file, kPeriodAt, 4)) / 1e6;
  auto points = std::make_shared<std::vector<Vector>>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + i * kRecordBytes + kPlaceAt;
    (*points)[i] = {millimetres(file, at), millimetres(file, at + 4), millimetres(file, at + 8)};
  }
  return [points, period_ms](double ms) {
    const double ticks = std::max(0.0, ms / period_ms);
    if (ticks >= static_cast<double>(points->size() - 1)) return points->back();
    const auto before = static_cast<std::size_t>(ticks);
    const double share = ticks - static_cast<double>(before);
    return (1 - share) * (*points)[before] + share * (*points)[before + 1];
  };
}

}  // namespace isotouch::falcon_model
