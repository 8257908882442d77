#include "host/field/cell_order.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isotouch::field {

namespace {

constexpr int kBits = 21;  // of a coordinate
constexpr int kDigit = 8;

/// The lower 21 bits, with two zeros after each.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001F00000000FFFF;
  bits = (bits | bits << 16) & 0x001F0000FF0000FF;
  bits = (bits | bits << 8) & 0x100F00F00F00F00F;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3;
  return (bits | bits << 2) & 0x1249249249249249;
}

std::uint64_t code_of(const Eigen::Vector3d& position) {
  constexpr double kMiddle = 1 << (kBits - 1);
  std::uint64_t code = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double along = std::clamp(std::floor(position[axis]) + kMiddle, 0.0, 2 * kMiddle - 1);
    code |= spread(static_cast<std::uint64_t>(along)) << axis;
  }
  return code;
}

}  // namespace

CellOrder::CellOrder(const std::vector<Eigen::Vector3d>& positions) : places_(positions.size()) {
  std::uint64_t differing = 0;
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    places_[i] = {code_of(positions[i]), i};
    differing |= places_[i].code ^ places_[0].code;
  }
  std::vector<Place> sorted(places_.size());
  for (int shift = 0; shift < 3 * kBits; shift += kDigit) {
    const auto digit = [shift](std::uint64_t code) { return static_cast<std::size_t>(code >> shift & ((1U << kDigit) - 1)); };
    if (digit(differing) == 0) continue;
    std::array<std::uint32_t, (1U << kDigit) + 1> begin{};
    for (const Place& place : places_) ++begin[digit(place.code) + 1];
    for (std::size_t d = 1; d < begin.size(); ++d) begin[d] += begin[d - 1];
    for (const Place& place : places_) sorted[begin[digit(place.code)]++] = place;
    places_.swap(sorted);
  }
}

std::vector<Cell> CellOrder::cells(int level) const {
  std::vector<Cell> cells;
  cut({0, static_cast<std::uint32_t>(places_.size()), kBits}, level, cells);
  return cells;
}

void CellOrder::cut(const Cell& cell, int level, std::vector<Cell>& parts) const {
  for (std::uint32_t first = cell.first; first < cell.last; first = parts.back().last) {
    const std::uint64_t end = ((places_[first].code >> 3 * level) + 1) << 3 * level;  // where the next part begins
    const auto next = std::partition_point(&places_[first], places_.data() + cell.last, [end](const Place& p) { return p.code < end; });
    parts.push_back({first, static_cast<std::uint32_t>(next - places_.data()), level});
  }
}

}  // namespace isotouch::field
