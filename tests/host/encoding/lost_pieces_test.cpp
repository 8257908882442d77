#include "host/encoding/lost_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/encoding/write_image.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_field.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::encoding {
namespace {

using field::box_mesh;
using field::joined;
using field::together;
using field::turned;

constexpr double kEdge = 0.5;

field::Grid grid_of_all() { return field::make_grid({-10, -10, -10}, {16, 10, 10}, kEdge, field::mesh_margin(3)); }

/// Between the two layers of samples that this coordinate lies between.
double between_layers(double coordinate, std::size_t axis) {
  const double first = grid_of_all().origin[static_cast<Eigen::Index>(axis)];
  return first + kEdge * (std::floor((coordinate - first) / kEdge) + 0.5);
}

LostPieces lost_of(const cloud::TriangleMesh& mesh) {
  const field::Grid grid = grid_of_all();
  const field_file::OpenField open = write_field(field::mesh_field(field::MeshDistance(mesh), grid, 3), {});
  return lost_pieces(mesh, open.view);
}

TEST(LostPieces, ThoseTooThinForTheGridAreCountedWithPlaceAndThickness) {
  const cloud::TriangleMesh body = box_mesh({-10, -10, -10}, {10, 10, 10});
  const LostPieces none = lost_of(together(body, box_mesh({12, -10, -10}, {14, 10, 10})));
  EXPECT_EQ(none.pieces + none.cavities, 0U);
  EXPECT_THAT(none.warnings({}), ::testing::IsEmpty());

  const double between = between_layers(12.5, 0);
  const auto plate = box_mesh({between - 0.075, -10, -10}, {between + 0.075, 10, 10});
  for (const auto& mesh : {together(body, plate), together(together(body, plate), turned(box_mesh({-5, -5, -5}, {5, 5, 5})))}) {
    const LostPieces one = lost_of(mesh);
    EXPECT_EQ(one.pieces, 1U);
    EXPECT_EQ(one.cavities, 0U);
    EXPECT_NEAR(one.place.x(), between, 0.1);
    EXPECT_NEAR(one.thickness_voxel, 0.3, 1e-9);
    EXPECT_THAT(one.warnings({}), ::testing::ElementsAre(::testing::StartsWith(
                                      "1 closed piece of the mesh is left out, or most of it, too thin for the grid, the first near (")));
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

TEST(LostPieces, OneThatRunsIntoSomethingThickIsLostAllTheSame) {
  const auto body = box_mesh({-10, -10, -10}, {10, 10, 10});
  const double middle = between_layers(0, 2);
  for (const double from : {2.0, 9.0, 10.0, 10.2}) {  // it ends inside the body, beside it, or stands on it
    const LostPieces lost = lost_of(together(body, box_mesh({from, -8, middle - 0.075}, {16, 8, middle + 0.075})));
    EXPECT_EQ(lost.pieces, 1U) << from;
    EXPECT_GT(lost.place.x(), 10) << from << ": it is named where it is missed";
    EXPECT_NEAR(lost.thickness_voxel, 0.3, 1e-9) << from;
  }
  const LostPieces thick = lost_of(together(body, box_mesh({9, -8, middle - 0.5}, {16, 8, middle + 0.5})));
  EXPECT_EQ(thick.pieces, 0U) << "of two voxels";
}

TEST(LostPieces, AFinThatSharesACornerOrAnEdgeIsAPiece) {
  const double top = between_layers(5, 2) - 0.075, back = between_layers(8, 1) - 0.075;
  const auto body = box_mesh({-10, -10, -10}, {10, back, top});
  const auto on_a_corner = joined(body, box_mesh({10, back, top}, {16, back + 0.15, top + 5}));
  // Prisms along the body's edge at x = 10, z = top.
  const auto on_an_edge = [&](double thickness) {
    auto fin = box_mesh({10, -10, top}, {16, back, top + thickness});
    for (auto& face : fin.faces)
      for (auto& vertex : face) vertex = vertex == 4 ? 0 : vertex == 6 ? 2 : vertex;  // no side along that edge
    std::erase_if(fin.faces, [](const auto& face) { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; });
    return joined(body, fin);
  };
  ASSERT_GT(cloud::signed_volume(on_an_edge(0.15)), cloud::signed_volume(body));
  EXPECT_EQ(lost_of(on_a_corner).pieces, 1U);
  EXPECT_EQ(lost_of(on_an_edge(0.15)).pieces, 1U);
  EXPECT_EQ(lost_of(on_an_edge(2)).pieces, 0U);

  // A row of plates that only together are thick.
  auto plates = box_mesh({10, -8, -8}, {10.1, 8, 8});
  for (int n = 1; n < 40; ++n) plates = joined(plates, box_mesh({10 + 0.1 * n, -8, -8}, {10 + 0.1 * (n + 1), 8, 8}));
  EXPECT_EQ(lost_of(plates).pieces, 0U);
}

}  // namespace
}  // namespace isotouch::encoding
