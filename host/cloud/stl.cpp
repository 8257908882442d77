#include "host/cloud/stl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

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

/// The triangles of a binary file, after which blanks and zeros may follow; nothing where the file is none.
std::optional<std::span<const std::uint8_t>> triangles(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes) return std::nullopt;
  const std::size_t size = kTriangleBytes * std::size_t{load_le<std::uint32_t>(bytes.data() + 80)};
  const auto body = bytes.subspan(kHeaderBytes);
  if (size > body.size()) return std::nullopt;
  const auto is_blank = [](std::uint8_t c) { return c == '\n' || c == '\r' || c == ' ' || c == 0; };
  if (!std::all_of(body.begin() + static_cast<std::ptrdiff_t>(size), body.end(), is_blank)) return std::nullopt;
  return body.first(size);
}

/// The next field of the line in small letters; empty at its end.
std::string keyword(TextLines& lines) {
  std::string word(lines.field().value_or(""));
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word;
}

Model read_binary(const std::string& name, std::span<const std::uint8_t> body) {
  Model model;
  model.format = "STL, binary";
  for (std::size_t at = 0; at < body.size(); at += kTriangleBytes) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Vector3d p;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = static_cast<double>(std::bit_cast<float>(load_le<std::uint32_t>(body.data() + at + 12 * corner + 4 * axis)));
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
  if (!lines.next() || keyword(lines) != "solid") {
    throw InputError(
        name +
        ": this is neither a binary STL file (its size does not fit its triangle count) nor an ascii one (it does not begin with 'solid')");
  }
  Model model;
  model.format = "STL, ascii";
  bool ended = false;
  while (lines.next()) {
    const std::string word = keyword(lines);
    if (word == "vertex") {
      if (with_decimal_commas(lines.rest()) >= 3) throw decimal_commas(lines);
      Vector3d p;
      for (double& value : p) {
        value = lines.number("a coordinate");
        if (!std::isfinite(value)) throw lines.refusal("a coordinate is not a finite number");
      }
      if (const auto extra = lines.field(); extra && as_number(*extra))
        throw lines.refusal(quote(*extra) + " follows the three coordinates of a vertex");
      model.positions.push_back(p);
      model.lines.push_back(lines.line());
    } else if (word == "endfacet") {
      if (model.positions.size() != 3 * (model.faces.size() + 1)) throw lines.refusal("a facet needs three vertices");
      add_face(model);
    } else if (word == "endsolid") {
      if (model.positions.size() != 3 * model.faces.size()) throw lines.refusal("the solid ends within a facet");
      ended = true;  // another solid may follow
    } else if (word == "solid") {
      ended = false;
    }
  }
  if (!ended) throw InputError(name + ": the file ends without 'endsolid'; it was cut short");
  return model;
}

}  // namespace

Model read_stl(const std::string& name, std::span<const std::uint8_t> bytes) {
  const auto body = triangles(bytes);
  return body ? read_binary(name, *body) : read_ascii(name, bytes);
}

}  // namespace isotouch::cloud
