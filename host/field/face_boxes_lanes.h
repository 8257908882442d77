/// The questions to sixteen boxes or faces, as many at a time as the source that includes this is compiled for. Each has its own: nothing here is shared.
#pragma once

#include <array>
#include <cstddef>

#include "host/field/face_boxes.h"
#include "host/field/simd.h"

namespace isotouch::field {

constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(float);
constexpr float kFarSquare = 1e36F;

static inline Lanes row_from(const Row& row, std::size_t first) { return load<Lanes>(&row[first]); }

static inline std::array<Lanes, 3> way_from(const Rows& middle, std::size_t first, const std::array<float, 3>& point) {
  return {point[0] - row_from(middle[0], first), point[1] - row_from(middle[1], first), point[2] - row_from(middle[2], first)};
}

static inline Lanes dot(const std::array<Lanes, 3>& way, const Rows& axis, std::size_t first) {
  return way[0] * row_from(axis[0], first) + way[1] * row_from(axis[1], first) + way[2] * row_from(axis[2], first);
}

/// Squared distances from `first` on, one a lane.
static inline Lanes squares_to(const FaceBoxes& boxes, std::size_t first, const std::array<float, 3>& point) {
  const std::array<Lanes, 3> way = way_from(boxes.middle, first, point);
  Lanes sum{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Lanes outside = larger(magnitude(dot(way, boxes.axes[a], first)) - row_from(boxes.half[a], first), Lanes{});
    sum += outside * outside;
  }
  return sum;
}

static inline Lanes squares_to(const FlatFaces& faces, std::size_t first, const std::array<float, 3>& point) {
  const std::array<Lanes, 3> way = way_from(faces.middle, first, point);
  const Lanes u = dot(way, faces.across, first), v = dot(way, faces.along, first), height = dot(way, faces.normal, first);
  Lanes beside = all<Lanes>(kFarSquare);  // to the nearest edge
  auto outside = beside < 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &from = faces.corner[k], &to = faces.corner[(k + 1) % 3];
    const Lanes from_u = row_from(from[0], first), from_v = row_from(from[1], first);
    const Lanes edge_u = row_from(to[0], first) - from_u, edge_v = row_from(to[1], first) - from_v;
    const Lanes way_u = u - from_u, way_v = v - from_v;
    const Lanes share = lesser(larger((way_u * edge_u + way_v * edge_v) * row_from(faces.inverse[k], first), Lanes{}), all<Lanes>(1));
    const Lanes off_u = way_u - share * edge_u, off_v = way_v - share * edge_v;
    beside = lesser(off_u * off_u + off_v * off_v, beside);
    outside |= edge_u * way_v - edge_v * way_u < 0.0F;
  }
  return height * height + (outside ? beside : Lanes{});
}

static inline unsigned boxes_within(const FaceBoxes& boxes, const std::array<float, 3>& point, float square) {
  unsigned near = 0;
  for (std::size_t n = 0; n < kTogether; n += kLanes) near |= true_lanes(squares_to(boxes, n, point) <= square) << n;
  return near;
}

static inline unsigned faces_within(const FlatFaces& faces, const std::array<float, 3>& point, float square, Row& squares) {
  unsigned near = 0;
  for (std::size_t n = 0; n < kTogether; n += kLanes) {
    const Lanes some = squares_to(faces, n, point);
    store(some, &squares[n]);
    near |= true_lanes(some <= square) << n;
  }
  return near;
}

}  // namespace isotouch::field
