#include "firmware/falcon/firmware_image.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "shared/bytes.h"

namespace isotouch::falcon {

namespace {

constexpr std::size_t kReservedAt = 2, kEntryAt = 18, kBlocksAt = 22;
constexpr std::uint32_t kAddresses = 1U << 22;          // the 28x core has 22 address lines
constexpr std::size_t kMaxFile = std::size_t{1} << 20;  // thirty times the DSP's memory

std::uint32_t load_high_first(const std::uint8_t* at) {
  return std::uint32_t{load_le<std::uint16_t>(at)} << 16 | load_le<std::uint16_t>(at + 2);
}

std::string text(const char* format, std::size_t a, std::size_t b = 0, std::size_t c = 0) {
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), format, a, b, c);
  return line.data();
}

}  // namespace

ImageReport check_image(std::span<const std::uint8_t> image) {
  ImageReport report;
  report.size = image.size();
  const auto defect = [&report](ImageDefect what, std::size_t offset) {
    report.defect = what;
    report.offset = offset;
    return report;
  };
  if (image.size() >= 2 && (image[0] != 0xAA || image[1] != 0x08)) return defect(ImageDefect::kWrongKey, 0);
  if (image.size() < kBlocksAt) return defect(ImageDefect::kTooShort, image.size());
  for (std::size_t at = kReservedAt; at < kEntryAt; ++at) {
    if (image[at] != 0) return defect(ImageDefect::kReserved, at);
  }
  report.entry = load_high_first(&image[kEntryAt]);
  if (report.entry >= kAddresses) return defect(ImageDefect::kWideAddress, kEntryAt);
  for (std::size_t at = kBlocksAt;;) {
    if (image.size() - at < 2) return defect(ImageDefect::kNoEnd, at);
    const std::size_t words = load_le<std::uint16_t>(&image[at]);
    if (words == 0) {
      if (image.size() - at > 2) return defect(ImageDefect::kTrailing, at + 2);
      return report.blocks == 0 ? defect(ImageDefect::kNoBlocks, at) : report;
    }
    if (image.size() - at < 6 + 2 * words) return defect(ImageDefect::kCutBlock, at);
    if (load_high_first(&image[at + 2]) + words > kAddresses) return defect(ImageDefect::kWideAddress, at + 2);
    at += 6 + 2 * words;
    ++report.blocks;
    report.words += words;
  }
}

std::string explain(const ImageReport& report) {
  switch (report.defect) {
    case ImageDefect::kNone: return text("%zu bytes, words: %zu, blocks: %zu", report.size, report.words, report.blocks);
    case ImageDefect::kTooShort: return text("it ends after %zu bytes, within its header of 22", report.size);
    case ImageDefect::kWrongKey: return "its first two bytes are not AA 08, so it is no firmware image of a Falcon";
    case ImageDefect::kReserved: return text("byte %zu is not zero, but bytes 2 to 17 of an image are", report.offset);
    case ImageDefect::kWideAddress: return text("the address at byte %zu lies beyond the memory of the device", report.offset);
    case ImageDefect::kCutBlock:
      return text("the block at byte %zu is longer than the rest of the image, which ends after %zu bytes", report.offset, report.size);
    case ImageDefect::kNoEnd: return text("the block of size zero that ends an image is missing at byte %zu", report.offset);
    case ImageDefect::kTrailing: return text("it ends at byte %zu, but %zu bytes follow", report.offset, report.size - report.offset);
    case ImageDefect::kNoBlocks: return text("it ends at byte %zu without a single block, so nothing would be loaded", report.offset);
  }
  return "unknown defect";
}

std::array<std::uint8_t, 34> synthetic_image() {
  return {0xAA, 0x08, 0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0, 0,
          0,    0x3F, 0x00, 0x02, 0x80, 0x02, 0x00, 0x3F, 0x00, 0x00, 0x80, 0x34, 0x12, 0x78, 0x56, 0, 0};
}

Refusal read_image(const std::string& path, std::vector<std::uint8_t>& image) {
  const std::string unusable = path + ": not usable as firmware: ";
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return unusable + std::strerror(errno) + "; give the path of a readable image";
  std::vector<std::uint8_t> bytes(kMaxFile + 1);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) return unusable + "it cannot be read; give the path of a file";
  if (bytes.size() > kMaxFile) return unusable + "it is larger than 1 MiB; a Falcon's image has a few thousand bytes";
  const ImageReport report = check_image(bytes);
  if (report.defect != ImageDefect::kNone) return unusable + explain(report) + "; take a fresh copy of the image";
  image = std::move(bytes);
  return {};
}

}  // namespace isotouch::falcon
