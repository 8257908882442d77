#include "host/vdb/level_set.h"

#include <array>
#include <fstream>
#include <new>

#include "host/cloud/forked_call.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/vdb/library.h"
#include "shared/hash64.h"

namespace isotouch::vdb {

namespace {

/// What reading a file may take: level sets shrink to a hundredth at most when they are saved, and a gigabyte is read within a minute.
cloud::ForkLimits limits_for(std::size_t file_bytes) {
  return {(std::uint64_t{512} << 20U) + 200 * std::uint64_t{file_bytes}, 20 + static_cast<unsigned>(file_bytes >> 22U)};
}

constexpr int kWidened = 4;
constexpr double kStencil = 2.5;  ///< how far the samples of an interpolation that carry weight may lie from its place

}  // namespace

bool is_vdb_file(const std::filesystem::path& file) {
  constexpr std::array<char, 8> kMagic = {' ', 'B', 'D', 'V', 0, 0, 0, 0};
  std::array<char, 8> begin{};
  std::ifstream stream(file, std::ios::binary);
  if (stream.read(begin.data(), begin.size()) && begin == kMagic) return true;
  return file.extension() == ".vdb";
}

LevelSet LevelSet::read(const std::filesystem::path& file, const std::string& grid_name) {
  const std::string name = file.string();
  const std::vector<std::uint8_t> bytes = read_file(file);
  const Library& openvdb = library();
  // A damaged count makes the library write beyond its buffers (3 of 250 mutated files, version 10.0.1, 2026-11), and where it throws it leaks.
  const cloud::ForkedCall trial = cloud::call_in_fork(
      [&] {
        try {
          openvdb.attempt(name, grid_name);
        } catch (const std::bad_alloc&) {
          throw InputError(name + ": the file is damaged: it asks for far more memory than a level set of its size needs; save it again");
        }
        return std::string();
      },
      limits_for(bytes.size()));
  if (trial.crashed) throw InputError(name + ": the file is damaged: reading it crashes OpenVDB; save it again");
  if (!trial.thrown.empty()) throw InputError(trial.thrown);
  LevelSet set = openvdb.read(name, grid_name);
  set.source_hash = hash64(bytes.data(), bytes.size());
  return set;
}

Interpolation::Interpolation(const LevelSet& set)
    : grid_(library().widened(*set.grid, kWidened)), reach_(set.half_width + kWidened - kStencil) {}

void Interpolation::distances(std::span<const Eigen::Vector3d> places, std::span<double> values) const {
  library().distances(*grid_, places, values);
}

std::vector<std::uint8_t> write_level_set(const field::BandField& field, const std::string& name, const Notes& notes) {
  return library().write(field, name, notes);
}

}  // namespace isotouch::vdb
