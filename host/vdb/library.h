/// What needs OpenVDB, as one table of functions. A module of its own holds them and the library, and is loaded when the first level set is named: the
/// library takes 40 ms to load, ten times as long as everything else of a small command.
#pragma once

#include "host/vdb/level_set.h"

namespace isotouch::vdb {

/// A file by its name, for sentences, and where its bytes are.
struct Source {
  std::string name;
  std::string path;
};

struct Library {
  /// Reads a grid and drops it; for a process of its own, which a damaged file may crash.
  void (*attempt)(const Source& file, const std::string& grid_name);
  /// All of a level set but the hash. Fails as `LevelSet::read` does.
  LevelSet (*read)(const Source& file, const std::string& grid_name);
  /// The band made wider by so many voxels on each side.
  std::shared_ptr<const LibraryGrid> (*widened)(const LibraryGrid& grid, int voxels);
  void (*distances)(const LibraryGrid& grid, std::span<const Eigen::Vector3d> places, std::span<double> values);
  std::vector<std::uint8_t> (*write)(const field::BandField& field, const std::string& name, const Notes& notes);
};

/// The module's name for its table: `extern "C" const Library* isotouch_openvdb()`.
inline constexpr const char* kTable = "isotouch_openvdb";

/// Loads the module at the first call.
///
/// fails     InputError: it is not there, or this program was built without it
const Library& library();

/// The module's own, and no other's.
LevelSet read_with_openvdb(const Source& file, const std::string& grid_name);
void attempt_with_openvdb(const Source& file, const std::string& grid_name);
std::shared_ptr<const LibraryGrid> widened_with_openvdb(const LibraryGrid& grid, int voxels);
void distances_with_openvdb(const LibraryGrid& grid, std::span<const Eigen::Vector3d> places, std::span<double> values);
std::vector<std::uint8_t> write_with_openvdb(const field::BandField& field, const std::string& name, const Notes& notes);

}  // namespace isotouch::vdb
