/// Stands in for the two files that need the library, where the build leaves it out (ISOTOUCH_OPENVDB).
#include "host/error.h"
#include "host/vdb/level_set.h"

namespace isotouch::vdb {

struct LevelSet::Grid {};

LevelSet LevelSet::read(const std::filesystem::path& file, const std::string&) {
  throw InputError(file.string() + ": this program was built without OpenVDB; build it with ISOTOUCH_OPENVDB to read level sets");
}

Interpolation::Interpolation(const LevelSet&) : reach_(0) {}

void Interpolation::distances(std::span<const Eigen::Vector3d>, std::span<double>) const {}

std::vector<std::uint8_t> write_level_set(const field::BandField&, const std::string&, const Notes&) {
  throw InputError("this program was built without OpenVDB; build it with ISOTOUCH_OPENVDB to write level sets");
}

}  // namespace isotouch::vdb
