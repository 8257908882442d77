#include "host/field/closed_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host/error.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

cloud::TriangleMesh cube() { return box_mesh({0, 0, 0}, {1, 1, 1}); }

std::string refusal(const cloud::TriangleMesh& mesh) {
  MeshRepair repair;
  try {
    closed_mesh(mesh, "a.stl", repair);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no refusal";
}

TEST(ClosedMesh, ABodyAndOneWithAHollowStayAsTheyAre) {
  MeshRepair repair;
  EXPECT_EQ(closed_mesh(cube(), "a.stl", repair).faces, cube().faces);
  EXPECT_THAT(repair.warnings(), IsEmpty());
  const auto hollow = together(cube(), turned(box_mesh({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8})));
  EXPECT_EQ(closed_mesh(hollow, "a.stl", repair).faces, hollow.faces);
  EXPECT_THAT(repair.warnings(), IsEmpty());
}

TEST(ClosedMesh, HolesAreClosedAndTheirRimsMeasured) {
  auto open = cube();
  open.faces.erase(open.faces.begin(), open.faces.begin() + 2);  // the square at z = 0
  open.faces.pop_back();                                         // and half of that at x = 1
  MeshRepair repair;
  const auto closed = closed_mesh(open, "a.stl", repair);
  EXPECT_DOUBLE_EQ(cloud::signed_volume(closed), 1);
  cloud::require_closed(closed, "a.stl");
  EXPECT_EQ(repair.holes, 2U);
  EXPECT_NEAR(repair.rim_length, 4 + 2 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR((repair.rim - Eigen::Vector3d(0.5, 0.5, 0)).norm(), 0, 1e-12);
  EXPECT_THAT(repair.warnings(), ElementsAre(HasSubstr("2 rims of 7.41421 units")));
}

TEST(ClosedMesh, RimsThatMeetAtACornerAreClosedOneByOne) {
  auto open = cube();
  open.faces.erase(open.faces.begin() + 2);  // {4, 5, 7}
  open.faces.erase(open.faces.begin());      // {0, 2, 3}
  open = together(open, box_mesh({1, 1, 1}, {2, 2, 2}));
  for (auto& face : open.faces) {
    for (auto& v : face) v = v == 8 ? 7 : v;
  }
  open.faces.erase(open.faces.end() - 12);  // {0, 2, 3} of the second: it begins at the corner that both share
  MeshRepair repair;
  EXPECT_DOUBLE_EQ(cloud::signed_volume(closed_mesh(open, "a.stl", repair)), 2);
  EXPECT_EQ(repair.holes, 3U);
}

TEST(ClosedMesh, OneThatIsInsideOutIsTurnedRound) {
  MeshRepair repair;
  EXPECT_DOUBLE_EQ(cloud::signed_volume(closed_mesh(turned(cube()), "a.stl", repair)), 1);
  EXPECT_THAT(repair.warnings(), ElementsAre(HasSubstr("pointed inwards")));
}

TEST(ClosedMesh, WhatBoundsNoBodyIsRefusedWithItsPlace) {
  auto against = cube();
  std::swap(against.faces[0][0], against.faces[0][1]);
  EXPECT_THAT(refusal(against), StartsWith("a.stl: at 3 edges neighbouring faces are oriented against each other, first near ("));
  auto flat = cube();
  flat.faces.resize(2);
  EXPECT_THAT(refusal(flat), StartsWith("a.stl: the faces enclose nothing, also when its rim is closed"));
  EXPECT_THAT(refusal(together(cube(), turned(box_mesh({5, 0, 0}, {5.5, 1, 1})))), StartsWith("a.stl: a closed piece of 12 faces near (5"));
}

TEST(ClosedMesh, AnInvertedPieceThatIsNotAllInAnotherOneIsRefused) {
  const auto body = box_mesh({0, 0, 0}, {10, 10, 10});
  const std::pair<const char*, cloud::TriangleMesh> others[] = {{"a corner in common", box_mesh({10, 10, 10}, {16, 16, 16})},
                                                                {"an edge in common", box_mesh({10, 10, 0}, {16, 16, 10})},
                                                                {"a face in common", box_mesh({10, 0, 0}, {15, 10, 10})},
                                                                {"it sticks out", box_mesh({4, 4, 5}, {6, 6, 14})},
                                                                {"its corner sticks out", box_mesh({4, 4, 4}, {10.2, 10.2, 10.2})}};
  for (const auto& [what, other] : others) EXPECT_THAT(refusal(joined(body, turned(other))), HasSubstr("faces that point inwards")) << what;
  EXPECT_EQ(refusal(joined(body, turned(box_mesh({2, 2, 2}, {10, 8, 8})))), "no refusal") << "a hollow that opens to nothing";
}

TEST(ClosedMesh, AnInvertedPieceIsRefusedThatSharesAllItsEdges) {
  const auto cubes = [](const Eigen::Vector3i& counts, const Eigen::Vector3i& inverted) {
    cloud::TriangleMesh mesh;
    for (int n = 0; n < counts.prod(); ++n) {
      const Eigen::Vector3i at(n % counts.x(), n / counts.x() % counts.y(), n / counts.x() / counts.y());
      const Eigen::Vector3d low = at.cast<double>();
      const auto one = box_mesh(low, low + Eigen::Vector3d(1, 1, 1));
      mesh = joined(mesh, at == inverted ? turned(one) : one);
    }
    return mesh;
  };
  for (const Eigen::Vector3i& counts : {Eigen::Vector3i(2, 2, 2), {3, 3, 3}, {3, 1, 1}, {2, 2, 1}}) {
    EXPECT_EQ(refusal(cubes(counts, {-1, -1, -1})), "no refusal") << counts.transpose();
    for (int n = 0; n < counts.prod(); ++n) {
      const Eigen::Vector3i at(n % counts.x(), n / counts.x() % counts.y(), n / counts.x() / counts.y());
      EXPECT_THAT(refusal(cubes(counts, at)), HasSubstr("faces that point inwards")) << counts.transpose() << ": " << at.transpose();
    }
  }
}

TEST(ClosedMesh, AnInvertedPieceIsAFlapIfNothingOfItCanBeSeen) {
  auto flapped = box_mesh({0, 0, 0}, {10, 10, 10});
  const auto& [a, b] = std::pair(3U, 7U);  // the edge at (10, 10)
  flapped.vertices.emplace_back(10.001, 10, 5);
  flapped.vertices.emplace_back(10, 10.001, 5);
  for (const std::array<std::uint32_t, 3>& face : {std::array{a, b, 8U}, {b, a, 9U}, {a, 8U, 9U}, {b, 9U, 8U}})
    flapped.faces.push_back(face);
  EXPECT_LT(cloud::signed_volume(flapped), 1000) << "the flap faces inwards";
  EXPECT_EQ(refusal(flapped), "no refusal");

  const auto body = box_mesh({0, 0, 0}, {10, 10, 10});
  const auto with_box_at_edge = [&](double side) { return joined(body, turned(box_mesh({10, 10, 0}, {10 + side, 10 + side, 10}))); };
  EXPECT_THAT(refusal(with_box_at_edge(0.1)), HasSubstr("a closed piece of 12 faces"));

  const auto with_box_at_side = [&](double side) {
    const auto small = box_mesh({20, 0, 0}, {20 + side, side, side});
    return together(body, joined(small, turned(box_mesh({20 + side, 0, 0}, {20 + 2 * side, side, side}))));
  };
  EXPECT_EQ(refusal(with_box_at_side(0.01)), "no refusal");
  EXPECT_THAT(refusal(with_box_at_side(0.1)), HasSubstr(": a piece of "));
}

TEST(ClosedMesh, APieceThatLiesInAnotherOneAndFacesOutwardHasNoEffectAndThatIsSaid) {
  const auto body = box_mesh({0, 0, 0}, {10, 10, 10}), inner = box_mesh({4, 4, 4}, {6, 6, 6});
  const auto warnings = [](const cloud::TriangleMesh& mesh) {
    MeshRepair repair;
    (void)closed_mesh(mesh, "a.stl", repair);
    return repair.warnings();
  };
  const auto said = StartsWith("1 closed piece lies within others and has no effect, the first near (");
  EXPECT_THAT(warnings(together(body, inner)), ElementsAre(said));
  EXPECT_THAT(warnings(together(inner, body)), ElementsAre(said));
  EXPECT_THAT(warnings(turned(together(body, inner))), ElementsAre(said, HasSubstr("all were reversed")));
  EXPECT_THAT(warnings(together(together(body, inner), box_mesh({1, 1, 1}, {2, 2, 2}))), ElementsAre(StartsWith("2 closed pieces lie")));
  const auto hollow = together(body, turned(box_mesh({1, 1, 1}, {9, 9, 9})));
  EXPECT_THAT(warnings(together(hollow, inner)), IsEmpty()) << "a body in a hollow";
  EXPECT_THAT(warnings(together(body, box_mesh({8, 8, 8}, {12, 12, 12}))), IsEmpty()) << "sticks out";
  EXPECT_THAT(warnings(together(body, box_mesh({10, 0, 0}, {20, 10, 10}))), IsEmpty()) << "touches";
}

TEST(ClosedMesh, OfAHollowThatIsClosedOnlyWithAnotherMostCounts) {
  const auto body = box_mesh({0, 0, 0}, {10, 10, 10});
  const auto up_to = [&](double high) {  // two hollows that share a side; the upper one sticks out of the body
    return together(body, turned(joined(box_mesh({4, 4, 2}, {6, 6, 5}), box_mesh({4, 4, 5}, {6, 6, high}))));
  };
  EXPECT_EQ(refusal(up_to(11)), "no refusal");
  EXPECT_THAT(refusal(up_to(40)), HasSubstr(": a piece of "));
}

TEST(ClosedMesh, WhereMostFacesPointInwardsThatIsTheBlame) {
  const auto right = box_mesh({0, 0, 0}, {4, 4, 4});
  EXPECT_THAT(refusal(together(right, turned(box_mesh({10, 0, 0}, {15, 5, 5})))),
              StartsWith("a.stl: most faces point inwards, but those of a closed piece of 12 faces near ("));
  EXPECT_THAT(refusal(joined(right, turned(box_mesh({4, 0, 0}, {8, 4, 4})))),
              StartsWith("a.stl: the faces enclose nothing, or those that point inwards as much as those that point outwards"));
}

/// Without its upper side.
cloud::TriangleMesh vessel(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  auto mesh = box_mesh(low, high);
  mesh.faces.erase(mesh.faces.begin() + 2, mesh.faces.begin() + 4);
  return mesh;
}

TEST(ClosedMesh, AnOpenMeshIsNotBlamedForWhatItsFansMakeOfIt) {
  const auto outside = vessel({0, 0, 0}, {10, 10, 10}), inside = vessel({2, 2, 2}, {8, 8, 10.5});  // a cup without a lip
  EXPECT_THAT(
      refusal(together(outside, turned(inside))),
      StartsWith(
          "a.stl: the mesh is open: 2 rims of 64 units length together, the longest round (5, 5, 10); when fans of faces close them, "));
  EXPECT_THAT(refusal(together(outside, turned(inside))),
              HasSubstr(", and there it lies in no other piece; join or close the rims in a mesh program"));
  EXPECT_THAT(refusal(turned(together(outside, turned(inside)))),
              AllOf(HasSubstr("2 rims of 64 units"), HasSubstr("join or close the rims in a mesh program"), Not(HasSubstr("reverse"))));
  EXPECT_THAT(refusal(together(outside, turned(box_mesh({20, 0, 0}, {22, 2, 2})))),
              AllOf(HasSubstr("1 rim of 40 units"), HasSubstr("a closed piece of 12 faces near (2"), HasSubstr("; reverse its faces")));
  MeshRepair repair;
  (void)closed_mesh(together(outside, inside), "a.stl", repair);
  EXPECT_THAT(repair.warnings(), ElementsAre(HasSubstr("; where one rim lies round another, join the two in a mesh program instead")));
}

TEST(ClosedMesh, HollowsMayOverlap) {
  const auto body = box_mesh({0, 0, 0}, {10, 10, 10});
  const auto a = turned(box_mesh({2, 2, 2}, {5, 5, 5})), b = turned(box_mesh({4, 4, 4}, {7, 7, 7})),
             c = turned(box_mesh({4, 3, 3}, {6, 6, 6}));
  const auto hollowed = together(together(body, a), b);
  EXPECT_EQ(refusal(hollowed), "no refusal");
  EXPECT_EQ(refusal(turned(hollowed)), "no refusal");
  EXPECT_EQ(refusal(together(hollowed, c)), "no refusal");
  EXPECT_EQ(refusal(together(body, turned(box_mesh({2, 2, 2}, {5, 5, 5.5})))), "no refusal");
  EXPECT_THAT(refusal(together(hollowed, turned(box_mesh({6, 6, 6}, {11, 9, 9})))),
              HasSubstr("there it lies in no other piece; reverse its faces"));
  const auto in_hollow = HasSubstr(" and lies in a hollow; reverse its faces if it is a body, or remove it if it is a hollow");
  EXPECT_THAT(refusal(together(hollowed, turned(box_mesh({3, 3, 3}, {3.5, 3.5, 3.5})))), in_hollow);
  EXPECT_THAT(refusal(turned(together(hollowed, turned(box_mesh({3, 3, 3}, {3.5, 3.5, 3.5}))))), in_hollow);
  EXPECT_THAT(refusal(together(hollowed, turned(box_mesh({4.2, 4.2, 4.2}, {4.8, 4.8, 4.8})))), in_hollow) << "in both";
  EXPECT_THAT(refusal(together(hollowed, box_mesh({4.2, 4.2, 4.2}, {4.8, 4.8, 4.8}))),
              HasSubstr("a closed piece of 12 faces near (4.4, 4.6, 4.2) lies where hollows overlap; unite the hollows"));
  EXPECT_EQ(refusal(together(hollowed, box_mesh({2.5, 2.5, 2.5}, {3.5, 3.5, 3.5}))), "no refusal") << "a body in one of them";
  const auto bars = together(turned(box_mesh({10, 44, 14}, {90, 56, 26})), turned(box_mesh({43.5, 9, 13.5}, {56.5, 91, 26.5})));
  EXPECT_THAT(refusal(together(together(box_mesh({0, 0, 0}, {100, 100, 40}), bars), box_mesh({47, 47, 17}, {53, 53, 23}))),
              HasSubstr("lies where hollows overlap"))
      << "no face of the hollows has its middle or a corner there";
}

TEST(ClosedMesh, FacesThatDoNotShareTheirCornersAreRefusedWithTheGap) {
  cloud::TriangleMesh soup;
  for (const auto& face : cube().faces) {
    for (const std::uint32_t corner : face)
      soup.vertices.push_back(cube().vertices[corner] * (1 + 1e-3 * static_cast<double>(soup.faces.size())));
    const auto end = static_cast<std::uint32_t>(soup.vertices.size());
    soup.faces.push_back({end - 3, end - 2, end - 1});
  }
  EXPECT_THAT(refusal(soup),
              ::testing::ContainsRegex("a.stl: neighbouring faces do not share their corners, which lie about 0\\.00[0-9]+ units "
                                       "apart; merge vertices by distance in a mesh program"));
  const cloud::TriangleMesh apart{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_THAT(refusal(apart), HasSubstr("the faces enclose nothing, also when its rim is closed"));
}

TEST(ClosedMesh, AFaceThatIsWrittenTwiceIsDroppedAndNoRim) {
  auto mesh = cube();
  const auto& [a, b, c] = mesh.faces[3];
  mesh.faces.push_back({b, c, a});
  MeshRepair repair;
  EXPECT_EQ(closed_mesh(mesh, "a.stl", repair).faces, cube().faces);
  EXPECT_THAT(repair.warnings(), ElementsAre(StartsWith("1 face was written more than once")));
}

}  // namespace
}  // namespace isotouch::field
