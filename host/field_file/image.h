/// A field's image in memory, and how it is read from a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/field_file/marks.h"

namespace isotouch::field_file {

/// The 8-byte aligned bytes of an image.
class Image {
 public:
  explicit Image(std::size_t bytes) : words_((bytes + 7) / 8), bytes_(bytes) {}
  std::uint8_t* data() { return reinterpret_cast<std::uint8_t*>(words_.data()); }
  const std::uint8_t* data() const { return reinterpret_cast<const std::uint8_t*>(words_.data()); }
  std::size_t size() const { return bytes_; }
  std::span<const std::uint8_t> bytes() const { return {data(), bytes_}; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t bytes_;
};

/// What a file holds. An image without a packed form around it has no marks.
struct StoredField {
  Image image;
  Marks invented = {};
};

/// Reads a file, unpacked where it is packed. The caller parses the image.
///
/// fails     InputError naming the file when it cannot be read or unpacked
StoredField read_field(const std::filesystem::path& file);
/// The same of a file's bytes.
StoredField read_field(const std::vector<std::uint8_t>& bytes, const std::string& name);

}  // namespace isotouch::field_file
