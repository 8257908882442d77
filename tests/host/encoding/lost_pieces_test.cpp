#include "host/encoding/lost_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "host/encoding/write_image.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_field.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::encoding {
namespace {

using field::box_mesh;
using field::together;
using field::turned;

constexpr double kEdge = 0.5;

LostPieces lost_of(const cloud::TriangleMesh& mesh) {
  const field::Grid grid = field::make_grid({-10, -10, -10}, {16, 10, 10}, kEdge, field::mesh_margin(3));
  const field_file::OpenField open = write_field(field::mesh_field(field::MeshDistance(mesh), grid, 3), {});
  return lost_pieces(mesh, open.view);
}

TEST(LostPieces, ThoseTooThinForTheGridAreCountedWithPlaceAndThickness) {
  const cloud::TriangleMesh body = box_mesh({-10, -10, -10}, {10, 10, 10});
  const LostPieces none = lost_of(together(body, box_mesh({12, -10, -10}, {14, 10, 10})));
  EXPECT_EQ(none.pieces + none.cavities, 0U);
  EXPECT_THAT(none.warnings({}), ::testing::IsEmpty());

  // Between two layers of samples, wherever these are.
  const field::Grid grid = field::make_grid({-10, -10, -10}, {16, 10, 10}, kEdge, field::mesh_margin(3));
  const double between = grid.origin.x() + kEdge * (std::floor((12.5 - grid.origin.x()) / kEdge) + 0.5);
  const auto plate = box_mesh({between - 0.075, -10, -10}, {between + 0.075, 10, 10});
  for (const auto& mesh : {together(body, plate), together(together(body, plate), turned(box_mesh({-5, -5, -5}, {5, 5, 5})))}) {
    const LostPieces one = lost_of(mesh);
    EXPECT_EQ(one.pieces, 1U);
    EXPECT_EQ(one.cavities, 0U);
    EXPECT_NEAR(one.place.x(), between, 0.1);
    EXPECT_NEAR(one.thickness_voxel, 0.3, 1e-9);
    EXPECT_THAT(one.warnings({}),
                ::testing::ElementsAre(::testing::StartsWith("1 closed piece of the mesh is left out, too thin for the grid")));
  }
  const double slot = between - 10;
  const LostPieces cavity = lost_of(together(body, turned(box_mesh({slot - 0.075, -8, -8}, {slot + 0.075, 8, 8}))));
  EXPECT_EQ(cavity.pieces, 0U);
  EXPECT_EQ(cavity.cavities, 1U);
  EXPECT_NEAR(cavity.thickness_voxel, 0.3, 1e-9);
}

TEST(LostPieces, AHollowThatAnotherPieceFillsIsNotLost) {
  const auto body = box_mesh({-10, -10, -10}, {10, 10, 10}), hollow = turned(box_mesh({-5, -5, -5}, {5, 5, 5}));
  const auto with_hollow = together(body, hollow);
  const std::pair<const char*, cloud::TriangleMesh> filled[] = {
      {"the body twice", together(with_hollow, body)},
      {"plugged", together(with_hollow, box_mesh({-5, -5, -5}, {5, 5, 5}))},
      {"plugged by more", together(with_hollow, box_mesh({-6, -6, -6}, {6, 6, 6}))},
      {"in two boxes", together(with_hollow, box_mesh({-7, -7, -7}, {16, 9, 9}))}};
  for (const auto& [what, mesh] : filled) {
    const LostPieces lost = lost_of(mesh);
    EXPECT_EQ(lost.pieces + lost.cavities, 0U) << what;
  }
  const auto slot = turned(box_mesh({0.02, -8, -8}, {0.12, 8, 8}));  // a part of which is filled
  EXPECT_EQ(lost_of(together(together(body, slot), box_mesh({-3, -9, -9}, {3, 9, 0}))).cavities, 1U);
}

}  // namespace
}  // namespace isotouch::encoding
