/// The core's formulas again, in double precision and written from their definitions: the twin that every stage is compared with.
#pragma once

#include "firmware/core/field_sampler.h"
#include "shared/field_view.h"
#include "tests/support/random.h"

namespace isotouch::test {

/// Value, gradient and second derivatives of a field.
struct ReferenceSample {
  double distance;
  Point gradient;
  Point second;
  Point mixed;  ///< yz, zx, xy
};

/// The definition in SPEC.md 2.1 at a point inside the grid: of a spline as a sum over 27 coefficients, of a trilinear field as the blend of what is
/// at the eight samples around the point.
ReferenceSample reference_sample(const FieldView& field, const Point& index);

struct ReferenceStiffness {
  double part;  ///< of the largest
  Point slope;  ///< ∇ ln k, a voxel
};

/// The stiffness at a point: the definition in SPEC.md 2.4, at a point between the outermost bricks' centres.
ReferenceStiffness reference_stiffness(const FieldView& field, const Point& index);

/// The step of a proxy as `core::step_towards` describes it, with eigenvectors instead of traces.
Point reference_step(const Point& pull, const ReferenceSample& sample);

inline double to_double(Voxel v) { return v.raw() / 65536.0; }
inline Point to_point(const Vec3<Voxel>& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
inline Vec3<Voxel> to_voxel(const Point& p) {
  const auto q = [](double v) { return Voxel::from_raw(static_cast<std::int32_t>(std::lround(v * 65536))); };
  return {q(p[0]), q(p[1]), q(p[2])};
}
inline double angle_degrees(const Point& a, const Point& b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 57.295779513082321; }

}  // namespace isotouch::test
