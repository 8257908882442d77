/// The header of a PLY file: what stands in the body, and where it begins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isotouch::cloud {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

constexpr std::size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8: return 1;
    case PlyType::kInt16:
    case PlyType::kUint16: return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32: return 4;
    case PlyType::kFloat64: return 8;
  }
  return 0;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;   ///< of the value, or of a list's items
  std::optional<PlyType> count_type;  ///< a list, its length in this type
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;                ///< as declared; nothing is promised about the body
  std::vector<PlyProperty> properties;  ///< at least one
};

/// What lines `obj_info` say of a range image.
struct PlyRangeInfo {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::optional<bool> cyberware;  ///< Stanford's scanner, which looks along -z, or else a camera in the origin, if the file says so
  bool warped = false;            ///< seen through a mirror, which turns the line of sight by 30 degrees about y
  bool right_mirror = true;       ///< through which of the two
  bool linear = true;             ///< not while the object was turned
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  PlyRangeInfo range;
  std::size_t bytes = 0;  ///< the body begins here
};

/// fails     InputError naming the line: bad grammar, unknown format, version or type, something declared twice, no `vertex` with scalar x y z,
///           only a part of a normal
PlyHeader read_ply_header(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
