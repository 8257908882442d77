/// Points sorted along a Morton curve: every cubic cell whose edge is a power of two is a run of them, and its eight parts are runs of it.
///
/// source    G. M. Morton, A computer oriented geodetic data base, 1966; sorted by digits, so that points of one cell stay in their order
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isotouch::field {

/// The points order[first] to order[last - 1]: those in one cell of edge 2^level, at least one.
struct Cell {
  std::uint32_t first, last;
  int level;

  std::size_t size() const { return last - first; }
};

class CellOrder {
 public:
  /// positions   coordinates from -2^20 to 2^20, others count as these
  explicit CellOrder(const std::vector<Eigen::Vector3d>& positions);

  std::size_t size() const { return places_.size(); }
  /// Which point comes n-th.
  std::uint32_t operator[](std::size_t n) const { return places_[n].point; }

  /// All cells of edge 2^level, level 0 to 21, along the curve.
  std::vector<Cell> cells(int level) const;
  /// Appends the parts of a cell that are cells of edge 2^level; itself where that is its own.
  void cut(const Cell& cell, int level, std::vector<Cell>& parts) const;

 private:
  struct Place {
    std::uint64_t code;  ///< bits of the three coordinates in turn
    std::uint32_t point;
  };

  std::vector<Place> places_;
};

}  // namespace isotouch::field
