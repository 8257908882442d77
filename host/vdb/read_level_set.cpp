#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/Interpolation.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <new>
#include <set>
#include <stdexcept>
#include <variant>

#include "host/error.h"
#include "host/vdb/library.h"

namespace isotouch::vdb {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3i;
using openvdb::Coord;
using openvdb::DoubleGrid;
using openvdb::FloatGrid;

constexpr double kFarthestPlace = 1e12;  // as of points (host/cloud/check.h)

/// world = linear * index + offset
struct Axes {
  Matrix3d linear;
  Vector3d offset;
  double edge;
};

std::string text(const Vector3d& p) {
  return '(' + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ')';
}

Vector3d eigen(const Coord& c) { return {static_cast<double>(c.x()), static_cast<double>(c.y()), static_cast<double>(c.z())}; }

/// To the six samples beside one.
const std::array<Coord, 6> kBeside = {Coord(-1, 0, 0), Coord(1, 0, 0), Coord(0, -1, 0), Coord(0, 1, 0), Coord(0, 0, -1), Coord(0, 0, 1)};

/// What a grid is that is no level set.
std::string kind_of(const openvdb::GridBase& grid) {
  switch (grid.getGridClass()) {
    case openvdb::GRID_FOG_VOLUME: return "a fog volume, a density without a surface; convert it to a level set (an SDF) where it was made";
    case openvdb::GRID_STAGGERED: return "a staggered grid of vectors, not a level set";
    case openvdb::GRID_LEVEL_SET: return "a level set with values of type " + grid.valueType() + "; save it with float values";
    default:
      return "a grid of type " + grid.valueType() + " without the class 'level set'; convert it to a level set (an SDF) where it was made";
  }
}

bool is_level_set(const openvdb::GridBase& grid) {
  return grid.getGridClass() == openvdb::GRID_LEVEL_SET && (grid.isType<FloatGrid>() || grid.isType<DoubleGrid>());
}

/// The level set of that name, or the first one.
openvdb::GridBase::Ptr read_grid(const Source& source, const std::string& grid_name, std::vector<std::string>& warnings) {
  const std::string& name = source.name;
  openvdb::io::File file(source.path);
  file.open(false);  // all of it now: nothing of the file is needed later
  const openvdb::GridPtrVecPtr all = file.readAllGridMetadata();
  if (!all || all->empty()) throw InputError(name + ": there is no grid in it");
  std::string found, names;
  std::size_t level_sets = 0;
  for (const auto& grid : *all) {
    names += (names.empty() ? "'" : ", '") + grid->getName() + "'";
    const bool wanted = grid_name.empty() ? is_level_set(*grid) : grid->getName() == grid_name;
    if (is_level_set(*grid)) ++level_sets;
    if (!wanted || !found.empty()) continue;
    if (!is_level_set(*grid)) throw InputError(name + ": grid '" + grid_name + "' is " + kind_of(*grid));
    found = grid->getName();
  }
  if (level_sets == 0 && grid_name.empty())
    throw InputError(name + ": grid '" + all->front()->getName() + "' is " + kind_of(*all->front()));
  if (found.empty() && !grid_name.empty()) throw InputError(name + ": there is no grid '" + grid_name + "' in it; there is " + names);
  if (grid_name.empty() && level_sets > 1) {
    warnings.push_back("of " + std::to_string(level_sets) + " level sets the first was taken, '" + found + "'; --grid-name names another");
  }
  auto grid = file.readGrid(found);
  if (grid->saveFloatAsHalf()) warnings.push_back("the values are stored as half floats, exact to 1 part in 2,000");
  return grid;
}

Axes axes_of(const openvdb::GridBase& grid, const std::string& name) {
  const std::string of = name + ": grid '" + grid.getName() + "' ";
  if (!grid.transform().isLinear()) throw InputError(of + "lies in a frustum; resample it on a grid of equal voxels");
  const openvdb::Mat4d m = grid.transform().baseMap()->getAffineMap()->getMat4();  // row vectors: world = index * m
  Axes axes{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) axes.linear(column, row) = m(row, column);
    axes.offset[row] = m(3, row);
  }
  axes.edge = axes.linear.col(0).norm();
  if (!axes.linear.allFinite() || !axes.offset.allFinite() || !(axes.edge > 0)) throw InputError(of + "has a transform without a size");
  const Matrix3d unit = axes.linear.transpose() * axes.linear / (axes.edge * axes.edge);
  if (!unit.isIdentity(1e-6)) throw InputError(of + "has voxels that are not cubes; resample it with one voxel size for all axes");
  return axes;
}

/// The same axes rounded to whole ones, column by column; nothing when they are turned by anything but right angles.
std::optional<Eigen::Matrix3i> permutation(const Axes& axes) {
  const Matrix3d unit = axes.linear / axes.edge;
  const Matrix3d whole = unit.array().round();
  if ((unit - whole).cwiseAbs().maxCoeff() > 1e-9) return std::nullopt;
  return whole.cast<int>();
}

/// Everything that is asked of one tree.
template <class Tree>
class Samples {
 public:
  Samples(const Tree& tree, const Axes& axes, const std::string& name, const std::string& grid_name)
      : tree_(tree), axes_(axes), of_(name + ": grid '" + grid_name + "' "), background_(static_cast<double>(tree.background())) {}

  /// Values are numbers and not too far away, tiles lie beyond the band, and the sign changes only within it.
  void check() const {
    if (tree_.empty() || tree_.leafCount() == 0) throw InputError(of_ + "is empty");
    constexpr std::int32_t kFarthest = 1 << 29;  // voxels: what is computed of two such places fits an int
    openvdb::CoordBBox leaves;
    tree_.evalLeafBoundingBox(leaves);
    if (!openvdb::CoordBBox(Coord(-kFarthest), Coord(kFarthest)).isInside(leaves))
      throw InputError(of_ + "has a value more than 536,870,912 voxels from its origin; move the object there where it was made");
    const Vector3d low = eigen(leaves.min()), high = eigen(leaves.max());
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d index((corner & 1 ? high : low).x(), (corner & 2 ? high : low).y(), (corner & 4 ? high : low).z());
      if (!((axes_.linear * index + axes_.offset).array().abs() <= kFarthestPlace).all())
        throw InputError(of_ + "reaches farther than 1e12 from the origin; the file is damaged or its units are unusable");
    }
    if (!std::isfinite(background_) || !(background_ >= axes_.edge)) {
      throw InputError(of_ + "has a background of " + std::to_string(background_) + "; a level set's is its half width, one voxel or more");
    }
    auto tile = tree_.cbeginValueAll();
    tile.setMaxDepth(decltype(tile)::LEAF_DEPTH - 1);
    for (; tile; ++tile) {
      if (!(std::abs(static_cast<double>(*tile)) >= 0.999 * background_)) {
        throw InputError(of_ + "has a block of constant distance " + std::to_string(*tile) + " at " + text(world(tile.getCoord())) +
                         "; it is no narrow band, rebuild the level set");
      }
    }
    Access access(tree_);
    for (auto leaf = tree_.cbeginLeaf(); leaf; ++leaf) {
      for (auto value = leaf->cbeginValueAll(); value; ++value) {
        const auto here = static_cast<double>(*value);
        const Coord place = value.getCoord();
        if (!std::isfinite(here)) throw InputError(of_ + "has a value that is no number at " + text(world(place)));
        for (const Coord& step : kBeside) {
          const auto there = static_cast<double>(access.getValue(place + step));
          if ((here < 0) != (there < 0) && std::min(std::abs(here), std::abs(there)) >= 0.999 * background_) {
            throw InputError(of_ + "jumps from inside to outside at " + text(world(place)) +
                             "; its surface is not closed, rebuild the level set");
          }
        }
      }
    }
  }

  /// Where the surface crosses the edges between samples.
  std::vector<Vector3d> crossings() const {
    std::vector<Vector3d> found;
    Access access(tree_);
    for (auto leaf = tree_.cbeginLeaf(); leaf; ++leaf) {
      for (auto value = leaf->cbeginValueAll(); value; ++value) {
        const auto here = static_cast<double>(*value);
        if (!(here < 0)) continue;
        for (const Coord& step : kBeside) {
          const auto there = static_cast<double>(access.getValue(value.getCoord() + step));
          if (there < 0) continue;
          const Vector3d index = eigen(value.getCoord()) + here / (here - there) * eigen(step);
          found.emplace_back(axes_.linear * index + axes_.offset);
        }
      }
    }
    return found;
  }

  /// The samples themselves, turned into the world's axes.
  field::BandField bricks(const Eigen::Matrix3i& turn) const {
    const openvdb::CoordBBox box = known();
    const Vector3i one = turn * Vector3i(box.min().x(), box.min().y(), box.min().z());
    const Vector3i two = turn * Vector3i(box.max().x(), box.max().y(), box.max().z());
    constexpr int kMargin = 3;  // samples round the band; a field's two outermost layers are far outside
    const auto brick_of = [](int n) { return n >= 0 ? n / 4 : -((3 - n) / 4); };
    const Vector3i first = 4 * (one.cwiseMin(two) - Vector3i::Constant(kMargin)).unaryExpr(brick_of);
    field::BandField field;
    field.grid.edge = axes_.edge;
    field.grid.size = one.cwiseMax(two) - first + Vector3i::Constant(kMargin + 1);
    field.grid.origin = axes_.offset + axes_.edge * first.cast<double>();
    field.band = background_ / axes_.edge;

    std::set<std::array<int, 3>> cells;  // z, y, x: the order of a field's bricks
    const auto list = [&](const Coord& c) {
      const Vector3i cell = (turn * Vector3i(c.x(), c.y(), c.z()) - first) / 4;
      cells.insert({cell.z(), cell.y(), cell.x()});
    };
    Access access(tree_);
    for (auto leaf = tree_.cbeginLeaf(); leaf; ++leaf) {
      for (auto value = leaf->cbeginValueAll(); value; ++value) {
        const auto here = static_cast<double>(*value);
        if (!in_band(here)) continue;
        list(value.getCoord());
        for (const Coord& step : kBeside) {  // where the sign jumps over the band, both sides are listed
          const auto there = static_cast<double>(access.getValue(value.getCoord() + step));
          if (!in_band(there) && (here < 0) != (there < 0)) list(value.getCoord() + step);
        }
      }
    }
    const Eigen::Matrix3i back = turn.transpose();
    for (const auto& [z, y, x] : cells) {
      field::Brick brick{{x, y, z}, {}};
      for (int n = 0; n < 64; ++n) {
        const Vector3i index = back * (first + 4 * brick.cell + Vector3i(n & 3, n >> 2 & 3, n >> 4));
        const auto value = static_cast<double>(access.getValue(Coord(index.x(), index.y(), index.z())));
        const double distance = in_band(value) ? value / axes_.edge : std::copysign(field.band + 1.0, value);
        brick.distance[static_cast<std::size_t>(n)] = static_cast<float>(distance);
      }
      field.bricks.push_back(brick);
    }
    return field;
  }

 private:
  using Access = openvdb::tree::ValueAccessor<const Tree>;

  bool in_band(double value) const { return std::abs(value) < background_; }
  Vector3d world(const Coord& place) const { return axes_.linear * eigen(place) + axes_.offset; }

  /// The box of all samples within the band.
  openvdb::CoordBBox known() const {
    openvdb::CoordBBox box;
    for (auto leaf = tree_.cbeginLeaf(); leaf; ++leaf) {
      for (auto value = leaf->cbeginValueAll(); value; ++value) {
        if (in_band(static_cast<double>(*value))) box.expand(value.getCoord());
      }
    }
    return box;
  }

  const Tree& tree_;
  const Axes& axes_;
  std::string of_;
  double background_;
};

FloatGrid::ConstPtr constant(const FloatGrid::Ptr& grid) { return grid; }
DoubleGrid::ConstPtr constant(const DoubleGrid::Ptr& grid) { return grid; }

/// Runs `read`; what the library throws becomes an InputError.
template <class Read>
auto guarded(const std::string& name, const Read& read) {
  try {
    openvdb::initialize();
    return read();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw InputError(name + ": OpenVDB cannot read it: " + e.what() + "; save it again");
  }
}

}  // namespace

struct LibraryGrid {
  std::variant<FloatGrid::ConstPtr, DoubleGrid::ConstPtr> values;
  Axes axes;
};

void attempt_with_openvdb(const Source& source, const std::string& grid_name) {
  guarded(source.name, [&] {
    std::vector<std::string> warnings;
    static_cast<void>(new openvdb::GridBase::Ptr(read_grid(source, grid_name, warnings)));
  });
}

LevelSet read_with_openvdb(const Source& source, const std::string& grid_name) {
  const std::string& file = source.name;
  return guarded(file, [&] {
    LevelSet set;
    const openvdb::GridBase::Ptr base = read_grid(source, grid_name, set.warnings);
    const Axes axes = axes_of(*base, file);
    set.format = "OpenVDB level set '" + base->getName() + "'";
    set.active_voxels = static_cast<std::size_t>(base->activeVoxelCount());
    set.edge = axes.edge;
    const auto take = [&](const auto& grid) {
      const Samples own(grid->tree(), axes, file, base->getName());
      own.check();
      set.half_width = static_cast<double>(grid->background()) / axes.edge;
      set.crossings = own.crossings();
      if (set.crossings.empty()) throw InputError(file + ": grid '" + base->getName() + "' has no surface: all of it is on one side");
      if (const auto turn = permutation(axes)) set.samples = own.bricks(*turn);
      set.grid = std::make_shared<LibraryGrid>(LibraryGrid{grid, axes});
    };
    if (const auto floats = openvdb::gridConstPtrCast<FloatGrid>(base))
      take(floats);
    else
      take(openvdb::gridConstPtrCast<DoubleGrid>(base));
    return set;
  });
}

std::shared_ptr<const LibraryGrid> widened_with_openvdb(const LibraryGrid& grid, int voxels) {
  const auto widen = [&](const auto& values) -> std::shared_ptr<const LibraryGrid> {
    return std::make_shared<LibraryGrid>(
        LibraryGrid{constant(openvdb::tools::dilateSdf(*values, voxels, openvdb::tools::NN_FACE_EDGE_VERTEX)), grid.axes});
  };
  return std::visit(widen, grid.values);
}

void distances_with_openvdb(const LibraryGrid& grid, std::span<const Vector3d> places, std::span<double> values) {
  const Matrix3d back = grid.axes.linear.inverse();
  std::visit(
      [&](const auto& samples) {
        const auto access = samples->getConstUnsafeAccessor();  // unregistered: the tree does not change
        for (std::size_t i = 0; i < places.size(); ++i) {
          const Vector3d index = back * (places[i] - grid.axes.offset);
          values[i] =
              static_cast<double>(openvdb::tools::QuadraticSampler::sample(access, openvdb::Vec3d(index.x(), index.y(), index.z())));
        }
      },
      grid.values);
}

}  // namespace isotouch::vdb
