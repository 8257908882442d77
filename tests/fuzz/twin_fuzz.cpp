/// The sampler beside its twin in doubles, on fields of any numbers: where both are defined, they agree to the last bits.
#include <array>
#include <cmath>

#include "firmware/core/field_sampler.h"
#include "firmware/core/surface_step.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

using namespace isotouch;

namespace {

constexpr std::uint32_t kSamples = 16;
constexpr double kStep = 1.0 / 65536;           // of what the sampler returns
constexpr double kSampleBound = 1.001 * kStep;  // tests/firmware/core/field_sampler_test.cpp has the same
constexpr double kSmallSlope = 0.2;             // below, |g|² counts as something larger

/// Samples from the input's bytes, again from the first when they end; between them they repeat so that a short input makes a whole field.
test::FieldImage field_of(fuzz::Front& front) {
  const auto head = front.take<std::uint8_t>();
  const bool is_trilinear = (head & 1U) != 0;
  const std::size_t period = 1 + front.take<std::uint16_t>() % (kSamples * kSamples);
  std::vector<double> samples;
  for (std::size_t i = 0; i < period; ++i) samples.push_back(front.take<std::int8_t>() / 127.0 * 7.9);
  std::size_t next = 0;
  return test::FieldImage(
      {kSamples, kSamples, kSamples}, [&](const test::Point&) { return samples[next++ % period]; },
      {.band = 7.9, .prefilter = false, .interpolation = is_trilinear ? Interpolation::kTrilinear : Interpolation::kSpline});
}

Voxel coordinate(fuzz::Front& front) {
  const auto raw = static_cast<std::int32_t>(front.take<std::uint32_t>() % ((kSamples - 3) * 65536)) + 65536;
  return Voxel::from_raw(raw);
}

void agree(double got, double exact, double bound, const char* what) {
  if (!(std::abs(got - exact) <= bound)) std::fprintf(stderr, "%.9g instead of %.9g\n", got, exact);
  fuzz::hold(std::abs(got - exact) <= bound, what);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Front front(data, size);
  const test::FieldImage image = field_of(front);
  for (int i = 0; i < 200 && !front.empty(); ++i) {
    const Vec3<Voxel> point{coordinate(front), coordinate(front), coordinate(front)};
    const core::FieldSample sample = core::sample_field(image.view(), point);
    const test::ReferenceSample twin = test::reference_sample(image.view(), test::to_point(point));
    fuzz::hold(!sample.outside_grid, "a point inside the grid is inside");
    agree(test::to_double(sample.distance), twin.distance, kSampleBound, "the distance is its twin's");
    const std::array<std::int32_t, 3> gradient = {sample.gradient.x.raw(), sample.gradient.y.raw(), sample.gradient.z.raw()};
    const std::array<std::int32_t, 3> second = {sample.second.x.raw(), sample.second.y.raw(), sample.second.z.raw()};
    const std::array<std::int32_t, 3> mixed = {sample.mixed.x.raw(), sample.mixed.y.raw(), sample.mixed.z.raw()};
    for (std::size_t c = 0; c < 3; ++c) {
      agree(gradient[c] * kStep, twin.gradient[c], kSampleBound, "the gradient is its twin's");
      agree(second[c] * kStep, twin.second[c], kSampleBound, "the second derivatives are their twin's");
      agree(mixed[c] * kStep, twin.mixed[c], kSampleBound, "the mixed derivatives are their twin's");
    }
    const test::Point slope{gradient[0] * kStep, gradient[1] * kStep, gradient[2] * kStep};
    const double square = test::dot(slope, slope);
    if (square < kSmallSlope * kSmallSlope) continue;
    core::SurfaceProjection projection;
    core::project_on_surface(point, point, sample, projection);
    const test::Point exact = slope * (-test::to_double(sample.distance) / square);
    const test::Point step = test::to_point(projection.step);
    for (std::size_t c = 0; c < 3; ++c) {  // |g|² and φ / |g|² have 16 fraction bits
      const double bound = (2 + std::abs(slope[c]) + 2 * std::abs(exact[c]) / square) * kStep;
      agree(step[c], exact[c], bound, "the projection is its twin's");
    }
  }
  return 0;
}
