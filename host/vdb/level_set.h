/// Level sets of OpenVDB: fields from other programs in, ours out. Nothing of that library is seen from here: its headers are slow to compile, and it is
/// slow to load.
///
/// A level set of OpenVDB is a sparse grid of distances in world units, negative inside, known up to the grid's background on both sides;
/// beyond stands plus or minus the background.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::vdb {

/// Do the file's bytes begin as an OpenVDB file, or its name end in .vdb?
bool is_vdb_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// A grid as the library holds it.
struct LibraryGrid;

/// A level set from a file. Lengths and places in its world units.
class LevelSet {
 public:
  /// Takes a grid of class level set with float or double values on a linear transform that scales all axes alike: moved, turned and mirrored as
  /// it likes. The library reads it at once, without mapping the file, first in a process of its own: a damaged file may
  /// crash it. What it throws becomes an InputError.
  ///
  /// bytes     of the file: the library reads a regular file by its name, and all others, such as standard input, from a copy in memory
  /// grid_name which grid; empty = the first level set
  /// fails     InputError: cannot be read; no grid of that name; none that is a level set, and what it is instead; unequal scales, shear or a
  ///           frustum; empty; values that are not finite; a background that is no distance; a surface that is not closed within its band; OpenVDB is not there
  static LevelSet read(const std::filesystem::path& file, std::span<const std::uint8_t> bytes, const std::string& grid_name);
  static LevelSet read(const std::filesystem::path& file, const std::string& grid_name = {});

  std::string format;                      ///< "OpenVDB level set 'ls_sphere'"
  std::uint64_t source_hash = 0;           ///< of the file's bytes
  std::size_t active_voxels = 0;           ///<
  double edge = 1;                         ///< of a voxel
  double half_width = 3;                   ///< voxels on each side of the surface
  std::vector<Eigen::Vector3d> crossings;  ///< where the surface crosses the grid's edges, linearly between two samples
  std::vector<std::string> warnings;       ///< one sentence each
  std::optional<field::BandField>
      samples;  ///< values in voxels on the file's own samples, the grid in world units; none when its axes are not the
                ///< world's, however permuted or mirrored

  std::shared_ptr<const LibraryGrid> grid;  ///< for `Interpolation`
};

/// A level set at any place, by parabolas between its samples. It is first widened by four voxels on each side, by a first-order sweep that
/// keeps the samples that are there, so that the parabolas meet no cut-off values. Error on a sphere of 20 voxels with a band of 3: 0.001 voxel
/// within 1 of the surface, 0.02 within 3, 0.1 up to the reach.
class Interpolation {
 public:
  explicit Interpolation(const LevelSet& set);

  /// How far from the surface the values are distances, voxels of the level set.
  double reach() const { return reach_; }

  /// World units; beyond the reach only the sign counts. May be called from several threads.
  void distances(std::span<const Eigen::Vector3d> places, std::span<double> values) const;

 private:
  std::shared_ptr<const LibraryGrid> grid_;
  double reach_;
};

/// Where a file comes from, for its readers: shown by `vdb_print -l`.
using Notes = std::vector<std::pair<std::string, std::string>>;

/// A field → the bytes of an OpenVDB file with one level set: values in mm, the transform gives workspace mm, background = band. Samples with
/// |distance| < band are active; what is not listed and inside is minus the background, by tiles.
///
/// field     bricks sorted by cell; where the sign changes from one sample to the next, both are listed
/// fails     InputError when OpenVDB is not there
std::vector<std::uint8_t> write_level_set(const field::BandField& field, const std::string& name, const Notes& notes);

}  // namespace isotouch::vdb
