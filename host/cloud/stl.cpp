#include "host/cloud/stl.h"

#include <bit>
#include <cmath>
#include <string_view>

#include "host/cloud/text_lines.h"
#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kTriangleBytes = 50;  // a normal and three corners, four bytes a number, and two spare bytes

void add_face(Model& model) {
  const auto next = static_cast<std::uint32_t>(model.positions.size());
  model.faces.push_back({next - 3, next - 2, next - 1});
}

bool is_binary(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes) return false;
  return bytes.size() == kHeaderBytes + kTriangleBytes * std::size_t{load_le<std::uint32_t>(bytes.data() + 80)};
}

Model read_binary(const std::string& name, std::span<const std::uint8_t> bytes) {
  Model model;
  model.format = "STL, binary";
  for (std::size_t at = kHeaderBytes; at < bytes.size(); at += kTriangleBytes) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Vector3d p;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = static_cast<double>(std::bit_cast<float>(load_le<std::uint32_t>(bytes.data() + at + 12 * corner + 4 * axis)));
        if (!std::isfinite(value))
          throw InputError(name + ": triangle " + std::to_string(model.faces.size() + 1) + ": a coordinate is not a finite number");
        p[static_cast<Eigen::Index>(axis)] = value;
      }
      model.positions.push_back(p);
    }
    add_face(model);
  }
  return model;
}

Model read_ascii(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes);
  if (!lines.next() || lines.field() != "solid") {
    throw InputError(
        name +
        ": this is neither a binary STL file (its size does not fit its triangle count) nor an ascii one (it does not begin with 'solid')");
  }
  Model model;
  model.format = "STL, ascii";
  bool ended = false;
  while (lines.next()) {
    const std::string_view keyword = lines.field().value_or("");
    if (keyword == "vertex") {
      if (with_decimal_commas(lines.rest()) >= 3) throw decimal_commas(lines);
      Vector3d p;
      for (double& value : p) {
        value = lines.number("a coordinate");
        if (!std::isfinite(value)) throw lines.refusal("a coordinate is not a finite number");
      }
      if (const auto extra = lines.field()) throw lines.refusal(quote(*extra) + " follows the three coordinates of a vertex");
      model.positions.push_back(p);
      model.lines.push_back(lines.line());
    } else if (keyword == "endfacet") {
      if (model.positions.size() != 3 * (model.faces.size() + 1)) throw lines.refusal("a facet needs three vertices");
      add_face(model);
    } else if (keyword == "endsolid") {
      if (model.positions.size() != 3 * model.faces.size()) throw lines.refusal("the solid ends within a facet");
      ended = true;  // another solid may follow
    } else if (keyword == "solid") {
      ended = false;
    }
  }
  if (!ended) throw InputError(name + ": the file ends without 'endsolid'; it was cut short");
  return model;
}

}  // namespace

Model read_stl(const std::string& name, std::span<const std::uint8_t> bytes) {
  return is_binary(bytes) ? read_binary(name, bytes) : read_ascii(name, bytes);
}

}  // namespace isotouch::cloud
