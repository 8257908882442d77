#include "shared/certificate.h"

#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "tests/support/field_image.h"

namespace isotouch {
namespace {

using namespace image_layout;
using test::Point;

/// A ball with the certificate that a writer would give it: slope 1.25, no wall, 2 N/mm at 1 kHz, 3 N·s/m, a delay of one tick.
class Certified {
 public:
  explicit Certified(const std::vector<std::pair<std::size_t, std::uint32_t>>& changes = {}) {
    const test::FieldImage image({40, 40, 40},
                                 [](const Point& p) {
                                   return test::length(p - Point{19.7, 20.1, 20.3}) - 11.0;
                                 },
                                 {.stiffness = 0.8});
    const std::vector<std::uint8_t> bytes = image.bytes();
    words_.resize((bytes.size() + 7) / 8);
    auto* at = reinterpret_cast<std::uint8_t*>(words_.data());
    std::memcpy(at, bytes.data(), bytes.size());
    std::vector<std::pair<std::size_t, std::uint32_t>> fields = {
        {kMaxSlopeAt, 81920},          {kQuantisationAt, 2048},    {kThinnestWallAt, 0}, {kAdvisedStiffnessAt, 131071},
        {kAdvisedPeriodAt, 1'000'000}, {kAdvisedDampingAt, 50332}, {kAdvisedDelayAt, 1}};
    fields.insert(fields.end(), changes.begin(), changes.end());
    for (const auto& [offset, value] : fields) store_le(at + offset, value);
    store_le(at + kChecksumAt, crc32(at + kTotalBytesAt, bytes.size() - kTotalBytesAt));
    view_ = *FieldView::parse({at, bytes.size()});
  }
  const FieldView& view() const { return view_; }

 private:
  std::vector<std::uint64_t> words_;
  FieldView view_;
};

const Loop kFalcon = {1'000'000, Damping::of(0.003), 1};

TEST(Certificate, TheLargestStiffnessIsThatOfTheFormula) {
  const auto of = [](double damping, std::uint32_t delay, std::uint32_t period) {
    return largest_stiffness({period, Damping::from_raw(static_cast<std::int32_t>(damping * (1 << 24))), delay}).raw() / 65536.0;
  };
  EXPECT_NEAR(of(0.003, 0, 1'000'000), 6.0, 0.0002);
  EXPECT_NEAR(of(0.003, 1, 1'000'000), 2.0, 0.0001);
  EXPECT_NEAR(of(0.003, 3, 1'000'000), 6.0 / 7.0, 0.0001);
  EXPECT_NEAR(of(0.003, 1, 250'000), 8.0, 0.0003);
  EXPECT_EQ(largest_stiffness({1'000'000, Damping{}, 1}), Stiffness{});
  EXPECT_EQ(largest_stiffness({0, Damping::of(1), 1}), Stiffness{});
  EXPECT_EQ(largest_stiffness({1, Damping::max(), 0}), Stiffness::max()) << "saturates";
  EXPECT_EQ(largest_stiffness({~0U, Damping::max(), ~0U}), Stiffness{}) << "no overflow";
}

TEST(Certificate, AGoodOneIsAcceptedUpToTheLoopsStiffness) {
  const Certified field;
  EXPECT_TRUE(check_certificate(field.view(), kFalcon, {}).accepted);
  const Stiffness largest = largest_stiffness(kFalcon);
  EXPECT_TRUE(check_certificate(field.view(), kFalcon, largest).accepted);
  const CertificateCheck above = check_certificate(field.view(), kFalcon, Stiffness::from_raw(largest.raw() + 1));
  EXPECT_FALSE(above.accepted);
  EXPECT_EQ(above.error, Error::kTooStiff);
  EXPECT_EQ(above.stiffness, largest);
}

TEST(Certificate, TheFieldsOwnStiffnessCountsWhereNoneIsWanted) {
  const Certified field;
  const CertificateCheck slow = check_certificate(field.view(), {4'000'000, Damping::of(0.003), 1}, {});  // 0.5 N/mm, the field has 0.8
  EXPECT_FALSE(slow.accepted);
  EXPECT_EQ(slow.error, Error::kTooStiff);
  EXPECT_NEAR(slow.stiffness.raw() / 65536.0, 0.5, 0.0001);
  EXPECT_TRUE(check_certificate(field.view(), {4'000'000, Damping::of(0.003), 1}, slow.stiffness).accepted);
}

TEST(Certificate, TheLoopItSpeaksOfIsReadBack) {
  const Loop loop = assumed_loop(Certified().view());
  EXPECT_EQ(loop.period_ns, 1'000'000U);
  EXPECT_EQ(loop.damping.raw(), 50332);
  EXPECT_EQ(loop.delay_ticks, 1U);
}

TEST(Certificate, EveryContradictionIsSeen) {
  const std::vector<std::vector<std::pair<std::size_t, std::uint32_t>>> lies = {
      {{kAdvisedStiffnessAt, 131075}},  // 2 N/mm is 131,072
      {{kAdvisedStiffnessAt, 131060}},
      {{kAdvisedStiffnessAt, ~0U}},
      {{kAdvisedPeriodAt, 1'000'500}},
      {{kAdvisedPeriodAt, 0}},
      {{kAdvisedDampingAt, 50345}},
      {{kAdvisedDampingAt, ~0U}},
      {{kAdvisedDelayAt, 2}},
      {{kAdvisedDelayAt, ~0U}},
      {{kMaxSlopeAt, 60000}},  // the ball rises by 0.99 from one coefficient to the next
      {{kMaxSlopeAt, 1}},
      {{kThinnestWallAt, 8 * 65536 + 1}},  // twice the band is 8 voxels
  };
  for (std::size_t n = 0; n < lies.size(); ++n) {
    const CertificateCheck check = check_certificate(Certified(lies[n]).view(), kFalcon, {});
    EXPECT_FALSE(check.accepted) << n;
    EXPECT_EQ(check.error, Error::kBadCertificate) << n;
    EXPECT_EQ(check.stiffness, Stiffness{}) << n;
  }
  const std::vector<std::vector<std::pair<std::size_t, std::uint32_t>>> truths = {
      {{kAdvisedStiffnessAt, 131072}}, {{kThinnestWallAt, 8 * 65536}}, {{kMaxSlopeAt, 66000}}};
  for (std::size_t n = 0; n < truths.size(); ++n) EXPECT_TRUE(check_certificate(Certified(truths[n]).view(), kFalcon, {}).accepted) << n;
}

/// A ball whose distance jumps at one plane, in voxels: between two bricks where `at` is a multiple of 4, else within them.
struct Stepped {
  Stepped(std::size_t axis, double step, double at, double largest_slope)
      : image({48, 48, 48},
              [=](const Point& p) {
                const double along = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
                return test::length(p - Point{23.7, 24.1, 24.3}) - 8.0 + (along >= at ? step : 0.0);
              },
              {.band = 7.9, .stiffness = 0.8, .largest_slope = largest_slope, .prefilter = false}) {}
  test::FieldImage image;
};

TEST(Certificate, AStepAtAFaceBetweenBricksIsSeen) {
  // Within a node (4 a side) and between two of them (16 a side); a certificate that tells 1.5, and none, which stands for 2.
  for (const double at : {20.0, 16.0}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double slope : {1.5, 0.0}) {
        EXPECT_TRUE(check_certificate(Stepped(axis, 0.1, at, slope).image.view(), kFalcon, {}).accepted)
            << axis << " " << at << " " << slope;
        for (const double step : {-6.0, 6.0}) {
          const CertificateCheck check = check_certificate(Stepped(axis, step, at, slope).image.view(), kFalcon, {});
          EXPECT_FALSE(check.accepted) << axis << " " << at << " " << slope << " " << step;
          EXPECT_EQ(check.error, slope == 0.0 ? Error::kTooSteep : Error::kBadCertificate);
        }
      }
    }
  }
}

TEST(Certificate, AStepWithinABrickIsSeen) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double at : {17.0, 18.0, 19.0}) {
      EXPECT_TRUE(check_certificate(Stepped(axis, 0.1, at, 1.5).image.view(), kFalcon, {}).accepted) << axis << " " << at;
      const CertificateCheck check = check_certificate(Stepped(axis, 6.0, at, 1.5).image.view(), kFalcon, {});
      EXPECT_FALSE(check.accepted) << axis << " " << at;
      EXPECT_EQ(check.error, Error::kBadCertificate);
    }
  }
}

TEST(Certificate, AHeaderAloneContradictsItselfButNoBrick) {
  const auto header_of = [](const Certified& field) {
    FieldView view = *FieldView::of_header(field.view().image.first(kHeaderBytes), field.view().image.size());
    view.image = field.view().image.first(kHeaderBytes);
    return view;
  };
  for (const auto& [offset, lie] : {std::pair{kAdvisedStiffnessAt, 131075U}, {kThinnestWallAt, 8 * 65536 + 1U}, {kAdvisedDelayAt, 2U}}) {
    EXPECT_EQ(check_certificate_header(header_of(Certified({{offset, lie}})), kFalcon, {}).error, Error::kBadCertificate) << offset;
  }
  EXPECT_TRUE(check_certificate_header(header_of(Certified()), kFalcon, {}).accepted);
  EXPECT_EQ(check_certificate_header(header_of(Certified()), kFalcon, Stiffness::of(2.1)).error, Error::kTooStiff);
  EXPECT_TRUE(check_certificate_header(header_of(Certified({{kMaxSlopeAt, 60000}})), kFalcon, {}).accepted) << "no brick was read";
}

TEST(Certificate, SteepGradientsNeedOneThatSaysSo) {
  for (const double slope : {1.9, 2.1}) {
    const test::FieldImage steep({40, 40, 40},
                                 [slope](const Point& p) {
                                   return slope * (test::length(p - Point{19.7, 20.1, 20.3}) - 11.0);
                                 },
                                 {.band = 7.0, .stiffness = 0.8});
    const CertificateCheck check = check_certificate(steep.view(), kFalcon, {});
    EXPECT_EQ(check.accepted, slope < 2) << slope;
    if (!check.accepted) {
      EXPECT_EQ(check.error, Error::kTooSteep);
    }
  }
}

TEST(Certificate, AFieldWithoutOneIsJudgedByItsStiffnessAlone) {
  const Certified none({{kMaxSlopeAt, 0}, {kAdvisedStiffnessAt, 0}, {kAdvisedPeriodAt, 0}, {kAdvisedDampingAt, 0}});
  EXPECT_TRUE(check_certificate(none.view(), kFalcon, {}).accepted);
  EXPECT_EQ(check_certificate(none.view(), kFalcon, Stiffness::of(2.1)).error, Error::kTooStiff);
}

}  // namespace
}  // namespace isotouch
