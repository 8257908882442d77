/// A field of an exact sphere round the origin, for the pictures' tests.
#pragma once

#include <cmath>

#include "host/encoding/write_image.h"
#include "shared/field_view.h"

namespace isotouch::view {

inline constexpr double kTestEdge = 0.5;    // mm
inline constexpr double kTestRadius = 8.0;  // mm: 16 voxels

struct SphereField {
  SphereField() : image(encoding::write_image(field(), {})), view(*FieldView::parse(image.bytes())) {}

  static field::BandField field() {
    field::BandField made;
    made.band = 4;
    made.grid.edge = kTestEdge;
    made.grid.size = {48, 48, 48};
    made.grid.origin = Eigen::Vector3d::Constant(-47 * kTestEdge / 2);
    for (int k = 0; k < 12; ++k) {
      for (int j = 0; j < 12; ++j) {
        for (int i = 0; i < 12; ++i) {
          field::Brick brick{{i, j, k}, {}};
          bool in_band = false;
          for (int s = 0; s < 64; ++s) {
            const Eigen::Vector3i sample(4 * i + (s & 3), 4 * j + ((s >> 2) & 3), 4 * k + (s >> 4));
            const double distance = (made.grid.position(sample).norm() - kTestRadius) / kTestEdge;
            brick.distance[static_cast<std::size_t>(s)] = static_cast<float>(distance);
            in_band |= std::fabs(distance) <= made.band;
          }
          if (in_band) made.bricks.push_back(brick);
        }
      }
    }
    return made;
  }

  field_file::Image image;
  FieldView view;
};

}  // namespace isotouch::view
