/// Band field → the bytes of a blob (shared/SPEC.md, section 2).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/band_field.h"

namespace isotouch::blob {

enum class Method : std::uint32_t { kDefault = 0, kPublished = 1 };

struct BlobInfo {
  double stiffness_n_per_mm = 0.8;
  std::uint64_t source_hash = 0;
  Method method = Method::kDefault;
  std::uint32_t point_count = 0;
  cloud::Placement placement;
};

/// The 8-byte aligned bytes of an image.
class Image {
 public:
  explicit Image(std::size_t bytes) : words_((bytes + 7) / 8), bytes_(bytes) {}
  std::uint8_t* data() { return reinterpret_cast<std::uint8_t*>(words_.data()); }
  const std::uint8_t* data() const { return reinterpret_cast<const std::uint8_t*>(words_.data()); }
  std::size_t size() const { return bytes_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t bytes_;
};

/// Turns distances into spline coefficients, rounds them and lays out the image.
///
/// fails     InputError when the field does not fit the format (size, band, origin)
Image write_blob(const field::BandField& field, const BlobInfo& info);

/// Reads a file into an image. The caller parses it.
///
/// fails     InputError naming the file when it cannot be read
Image read_image(const std::filesystem::path& file);

/// Writes to a temporary beside `file`, then renames: the old file or the new one, never half of one.
///
/// fails     InputError naming the file
void write_file(const std::filesystem::path& file, const std::uint8_t* data, std::size_t size);

}  // namespace isotouch::blob
