#include "shared/vec3.h"

#include <gtest/gtest.h>

#include <limits>

#include "shared/units.h"

namespace isotouch {
namespace {

template <class A, class B>
concept CanAdd = requires(A a, B b) {
  a + b;
};
static_assert(CanAdd<Vec3<Mm>, Vec3<Mm>> && !CanAdd<Vec3<Mm>, Vec3<Newton>> && !CanAdd<Vec3<Mm>, Mm>);
static_assert(std::is_trivially_copyable_v<Vec3<Mm>> && sizeof(Vec3<Mm>) == 12);

constexpr Vec3<Mm> kA{Mm::of(1), Mm::of(-2), Mm::of(3)};
constexpr Vec3<Mm> kB{Mm::of(10), Mm::of(20), Mm::of(-30)};

TEST(Vec3, SumsGoByComponent) {
  static_assert(kA + kB == Vec3<Mm>{Mm::of(11), Mm::of(18), Mm::of(-27)});
  static_assert(kA - kB == Vec3<Mm>{Mm::of(-9), Mm::of(-22), Mm::of(33)});
  static_assert(-kA == Vec3<Mm>{} - kA);
}

TEST(Vec3, OneFactorScalesEveryComponent) {
  static_assert(mul<Newton>(kA, Stiffness::of(0.5)) == Vec3<Newton>{Newton::of(0.5), Newton::of(-1), Newton::of(1.5)});
}

TEST(Vec3, TheDotProductIsExactUpToItsStatedRange) {
  static_assert(dot_raw(kA, kB) == (10LL - 40 - 90) * (1LL << 40));
  constexpr Mm kEdge = Mm::from_raw((1 << 30) - 1);
  constexpr std::int64_t kSquare = std::int64_t{kEdge.raw()} * kEdge.raw();
  static_assert(dot_raw(Vec3<Mm>{kEdge, kEdge, kEdge}, Vec3<Mm>{kEdge, kEdge, kEdge}) == 3 * kSquare);
  static_assert(dot_raw(Vec3<Mm>{kEdge, kEdge, kEdge}, Vec3<Mm>{-kEdge, -kEdge, -kEdge}) == -3 * kSquare);
}

TEST(Vec3, EqualMeansEveryComponent) {
  EXPECT_NE(kA, (Vec3<Mm>{kA.x, kA.y, kA.z + Mm::from_raw(1)}));
  EXPECT_NE(kA, (Vec3<Mm>{kA.x, kA.y + Mm::from_raw(1), kA.z}));
  EXPECT_NE(kA, (Vec3<Mm>{kA.x + Mm::from_raw(1), kA.y, kA.z}));
}

}  // namespace
}  // namespace isotouch
