#include "host/cloud/mesh_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Bytes of known number, one value after the other.
class Packed {
 public:
  Packed(std::string_view begin, std::size_t more) : bytes_(begin.begin(), begin.end()) { bytes_.reserve(begin.size() + more); }

  template <class Integer>
  void add(Integer value) {
    bytes_.resize(bytes_.size() + sizeof value);
    store_le(bytes_.data() + bytes_.size() - sizeof value, value);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add_single(double value) { add(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// The largest step between two numbers of single precision in the mesh's range.
double single_step(const TriangleMesh& mesh) {
  double farthest = 0;
  for (const Vector3d& vertex : mesh.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  const auto single = static_cast<float>(farthest);
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity()) - single);
}

}  // namespace

std::vector<std::uint8_t> ply_bytes(const TriangleMesh& mesh, const std::string& comment) {
  const std::string header = "ply\nformat binary_little_endian 1.0\ncomment " + comment + "\nelement vertex " +
                             std::to_string(mesh.vertices.size()) +
                             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                             std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  Packed packed(header, 24 * mesh.vertices.size() + 13 * mesh.faces.size());
  for (const Vector3d& vertex : mesh.vertices) {
    for (const double value : vertex) packed.add(value);
  }
  for (const auto& face : mesh.faces) {
    packed.add(std::uint8_t{3});
    for (const std::uint32_t corner : face) packed.add(corner);
  }
  return packed.take();
}

std::vector<std::uint8_t> obj_bytes(const TriangleMesh& mesh, const std::string& comment, double resolution) {
  int places = 0;
  for (double step = 1; step > resolution && places < 17; ++places) step /= 10;
  std::string text = "# " + comment + '\n';
  std::array<char, 340> digits;  // a sign, up to 309 digits, a point and 17 digits
  const auto add = [&](char before, const std::to_chars_result& number) {
    text += before;
    text.append(digits.data(), number.ptr);
  };
  for (const Vector3d& vertex : mesh.vertices) {
    text += 'v';
    for (const double value : vertex)
      add(' ', std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, places));
    text += '\n';
  }
  for (const auto& face : mesh.faces) {
    text += 'f';
    for (const std::uint32_t corner : face) add(' ', std::to_chars(digits.data(), digits.data() + digits.size(), corner + 1));
    text += '\n';
  }
  return {text.begin(), text.end()};
}

std::vector<std::uint8_t> stl_bytes(const TriangleMesh& mesh, const std::string& name, const std::string& comment, double resolution) {
  if (single_step(mesh) > resolution) {
    throw InputError(name + ": an STL file cannot hold this surface: so far from the origin its numbers are " +
                     std::to_string(single_step(mesh)) + " apart; write PLY or OBJ");
  }
  std::string header = comment.substr(0, 79);
  header.resize(80);
  Packed packed(header, 4 + 50 * mesh.faces.size());
  packed.add(static_cast<std::uint32_t>(mesh.faces.size()));
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    for (const double value : face_normal(mesh, face)) packed.add_single(value);
    for (const std::uint32_t corner : mesh.faces[face]) {
      for (const double value : mesh.vertices[corner]) packed.add_single(value);
    }
    packed.add(std::uint16_t{0});
  }
  return packed.take();
}

}  // namespace isotouch::cloud
