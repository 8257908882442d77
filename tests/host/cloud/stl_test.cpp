#include "host/cloud/stl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

const std::vector<Vector3d> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 2.5, 0}};

TEST(Stl, AsciiFacetsBecomeFaces) {
  const std::string text =
      "solid a thing\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 2.5 0\n endloop\nendfacet\nendsolid a "
      "thing\n";
  const Model model = read_stl("f.stl", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  EXPECT_EQ(model.positions, kCorners);
  EXPECT_EQ(model.faces.size(), 1U);
}

std::vector<std::uint8_t> binary() {
  std::vector<std::uint8_t> bytes(84 + 50);
  const std::string title = "solid but binary";
  std::copy(title.begin(), title.end(), bytes.begin());
  store_le(bytes.data() + 80, std::uint32_t{1});
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<float>(kCorners[corner][static_cast<Eigen::Index>(axis)]);
      store_le(bytes.data() + 84 + 12 * (corner + 1) + 4 * axis, std::bit_cast<std::uint32_t>(value));
    }
  }
  return bytes;
}

TEST(Stl, ABinaryFileMayBeginLikeAnAsciiOne) {
  std::vector<std::uint8_t> bytes = binary();
  const Model model = read_stl("f.stl", bytes);
  EXPECT_EQ(model.positions, kCorners);
  bytes.pop_back();
  EXPECT_THROW(read_stl("f.stl", bytes), InputError);
}

TEST(Stl, BlanksMayFollowABinaryFile) {
  for (const char last : {'\n', '\r', ' ', '\0', 'x'}) {
    std::vector<std::uint8_t> bytes = binary();
    bytes.push_back(static_cast<std::uint8_t>(last));
    if (last == 'x') {
      EXPECT_THROW(read_stl("f.stl", bytes), InputError);
    } else {
      EXPECT_EQ(read_stl("f.stl", bytes).positions, kCorners) << static_cast<int>(last);
    }
  }
}

std::string ascii(const std::string& first_corner) {
  return "solid\nfacet normal 0 0 1\nouter loop\nvertex " + first_corner + "\nvertex 1 0 0\nvertex 0 2.5 0\nendloop\nendfacet\nendsolid\n";
}

std::string refusal(const std::string& text) {
  try {
    read_stl("f.stl", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Stl, AsciiKeywordsMayBeLarge) {
  std::string text = ascii("0 0 0");
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  EXPECT_EQ(read_stl("f.stl", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}).positions, kCorners);
}

TEST(Stl, DecimalCommasAndAFourthNumberAreRefused) {
  EXPECT_EQ(refusal(ascii("0,5 2,5 0,0")), "f.stl: line 4: its numbers have decimal commas; save them with decimal points");
  EXPECT_EQ(refusal(ascii("0 0 0 1")), "f.stl: line 4: '1' follows the three coordinates of a vertex");
  EXPECT_EQ(refusal(ascii("0, 0, 0")), "");
  EXPECT_EQ(refusal(ascii("0 0 0 # a")), "");
}

}  // namespace
}  // namespace isotouch::cloud
