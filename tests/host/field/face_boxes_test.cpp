#include "host/field/face_boxes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "host/field/vector_lanes.h"

namespace isotouch::field {
namespace {

class Numbers {
 public:
  float operator()() { return static_cast<float>(engine_() % 4096) / 2048.0F - 1.0F; }
  void fill(Row& row) {
    for (float& number : row) number = (*this)();
  }
  void fill(Rows& rows) {
    for (Row& row : rows) fill(row);
  }

 private:
  std::mt19937 engine_{7};
};

TEST(FaceBoxes, WiderVectorsGiveTheBitsOfFour) {
  Numbers number;
  std::size_t within = 0;
  for (int trial = 0; trial < 200; ++trial) {
    FaceBoxes boxes{};
    FlatFaces faces{};
    for (Rows* rows : {&boxes.middle, &boxes.axes[0], &boxes.axes[1], &boxes.axes[2], &boxes.half, &faces.middle, &faces.across,
                       &faces.along, &faces.normal, &faces.inverse})
      number.fill(*rows);
    for (auto& corner : faces.corner) number.fill(corner[0]), number.fill(corner[1]);
    const std::array<float, 3> point = {number(), number(), number()};
    Row by_four{}, wider{};
    const unsigned near_boxes = kWithinByFours.boxes(boxes, point, 1.0F), near_faces = kWithinByFours.faces(faces, point, 1.0F, by_four);
    within += (near_boxes != 0 ? 1U : 0U) + (near_faces != 0 ? 1U : 0U);
    const auto agrees = [&](const FacesWithin& other) {
      EXPECT_EQ(other.boxes(boxes, point, 1.0F), near_boxes);
      EXPECT_EQ(other.faces(faces, point, 1.0F, wider), near_faces);
      EXPECT_EQ(wider, by_four);
    };
    if (vector_lanes() >= 8) agrees(kWithinByEights);
    if (vector_lanes() >= 16) agrees(kWithinBySixteens);
  }
  EXPECT_GT(within, 100U);
}

}  // namespace
}  // namespace isotouch::field
