#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/vdb/library.h"

namespace isotouch::vdb {

namespace {

openvdb::math::Transform::Ptr transform_of(const field::Grid& grid) {
  auto transform = openvdb::math::Transform::createLinearTransform(grid.edge);
  transform->postTranslate(openvdb::Vec3d(grid.origin.x(), grid.origin.y(), grid.origin.z()));
  return transform;
}

}  // namespace

std::vector<std::uint8_t> write_with_openvdb(const field::BandField& field, const std::string& name, const Notes& notes) {
  openvdb::initialize();
  const auto background = static_cast<float>(field.band * field.grid.edge);
  const auto grid = openvdb::FloatGrid::create(background);
  grid->setName(name);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setTransform(transform_of(field.grid));
  grid->setCreator("isotouch");
  for (const auto& [key, text] : notes) grid->insertMeta(key, openvdb::StringMetadata(text));
  auto access = grid->getAccessor();
  for (const field::Brick& brick : field.bricks) {
    for (int n = 0; n < 64; ++n) {
      const Eigen::Vector3i sample = 4 * brick.cell + Eigen::Vector3i(n & 3, n >> 2 & 3, n >> 4);
      const double distance = static_cast<double>(brick.distance[static_cast<std::size_t>(n)]);
      const double held = std::clamp(distance, -field.band, field.band) * field.grid.edge;
      access.setValueOn({sample.x(), sample.y(), sample.z()}, static_cast<float>(held));
    }
  }
  // The fill gives all that is not active the sign of what is active before it, so a listed sample is active until then, far outside or not.
  openvdb::tools::signedFloodFill(grid->tree());
  for (auto leaf = grid->tree().beginLeaf(); leaf; ++leaf) {
    for (auto value = leaf->beginValueOn(); value; ++value) {
      if (std::abs(*value) >= background) value.setValueOff();
    }
  }
  grid->pruneGrid();
  std::ostringstream bytes;
  openvdb::io::Stream(bytes).write(openvdb::GridCPtrVec{grid});
  const std::string text = bytes.str();
  return {text.begin(), text.end()};
}

}  // namespace isotouch::vdb
