#include "host/field/patch_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace isotouch::field {

namespace {

// All figures of this block by trials of 2026-11 on five shapes and ten scanned objects; none is sharp, a factor of two changes the error by 1 to 3 %.
constexpr double kStraightness =
    1e-3;  ///< pull of the first curvatures to zero, as a share of the samples' spread: at 0.01 spheres come out flat
constexpr double kPositionWeight = 16.0;  ///< an offset of reach / 4 counts as much as a normal that is a radian off
constexpr double kOwnPosition = 10.0;     ///< the sample's own position counts more: the surface shall pass through it
constexpr double kOwnNormal = 3.0;
constexpr double kKeepTilt = 1e-3;  ///< pull of the correction to zero; it decides only where the samples say nothing
constexpr double kKeepCurvature = 2e-3;
constexpr double kKeepNoisy = 0.02;  ///< the same in `nearer_patch`, of a normal: 0.005 and 0.1 change the volume of thin rods by 0.4 %
constexpr std::size_t kFewestForCorrection = 4;  ///< with fewer the sample's own normal is the better one

/// Symmetric second-order form in a tangent frame: H = [a b; b c].
struct Form {
  Eigen::Vector3d e, f;  ///< unit, orthogonal to each other and to the normal
  double a, b, c;
};

/// The patch with the form's eigenvalues as curvatures.
ToroidalPatch patch_of(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, const Form& form) {
  const double mean = 0.5 * (form.a + form.c);
  const double half = 0.5 * (form.a - form.c);
  const double spread = std::sqrt(half * half + form.b * form.b);
  Eigen::Vector2d d(1.0, 0.0);  // of the eigenvalue mean + spread
  if (spread > 0.0) d = (half > 0.0 ? Eigen::Vector2d(half + spread, form.b) : Eigen::Vector2d(form.b, spread - half)).normalized();
  const Eigen::Vector3d first = d.x() * form.e + d.y() * form.f;
  const Eigen::Vector3d second = -d.y() * form.e + d.x() * form.f;
  ToroidalPatch patch{point, normal, first, second, mean + spread, mean - spread};
  if (std::abs(patch.gentle) > std::abs(patch.tight)) {
    std::swap(patch.across, patch.along);
    std::swap(patch.gentle, patch.tight);
  }
  return patch;
}

ToroidalPatch fit_curvatures(std::span<const WeightedSample> samples) {
  const auto& own = samples.front();
  Form form{own.normal.unitOrthogonal(), {}, 0.0, 0.0, 0.0};
  form.f = own.normal.cross(form.e);
  // Each sample says a u + b v = du and b u + c v = dv.
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double spread = 0.0;
  for (const auto& other : samples.subspan(1)) {
    const Eigen::Vector3d step = other.position - own.position;
    const Eigen::Vector3d turn = other.normal - own.normal;
    const double u = step.dot(form.e), v = step.dot(form.f);
    const Eigen::Vector3d first(u, v, 0.0), second(0.0, u, v);
    squares += other.weight * (first * first.transpose() + second * second.transpose());
    right += other.weight * (first * turn.dot(form.e) + second * turn.dot(form.f));
    spread += other.weight * (u * u + v * v);
  }
  if (spread > 0.0) {
    squares.diagonal().array() += kStraightness * spread;
    const Eigen::Vector3d h = squares.ldlt().solve(right);
    form.a = h[0], form.b = h[1], form.c = h[2];
  }
  return patch_of(own.position, own.normal, form);
}

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The equations of one Gauss-Newton step. Near the patch its distance is w - t - αu - βv + ½(Au² + 2Buv + Cv²) for small t, α, β, A, B, C.
class Step {
 public:
  explicit Step(const ToroidalPatch& patch) : patch_(patch) {}

  void add(const WeightedSample& sample, double position_weight, double normal_weight) {
    constexpr std::array<Eigen::Index, 6> kAll = {0, 1, 2, 3, 4, 5};
    constexpr std::array<Eigen::Index, 3> kAcross = {1, 3, 4}, kAlong = {2, 4, 5};
    const Eigen::Vector3d step = sample.position - patch_.point;
    const double u = step.dot(patch_.across), v = step.dot(patch_.along);
    const auto there = patch_.value(sample.position);
    const Eigen::Vector3d turn = sample.normal - there.gradient;
    add(position_weight, kAll, std::array{-1.0, -u, -v, 0.5 * u * u, u * v, 0.5 * v * v}, -there.distance);
    add(normal_weight, kAcross, std::array{-1.0, u, v}, turn.dot(patch_.across));
    add(normal_weight, kAlong, std::array{-1.0, u, v}, turn.dot(patch_.along));
  }

  /// flat, bent   pull of tilt and of curvatures to zero
  ToroidalPatch taken(double flat, double bent, double reach) {
    squares_.diagonal() += (Vector6() << flat / (reach * reach), flat, flat, bent, bent, bent).finished();
    const Vector6 x = squares_.ldlt().solve(right_);
    const Eigen::Vector3d normal = (patch_.normal - x[1] * patch_.across - x[2] * patch_.along).normalized();
    Form form{(patch_.across - normal * normal.dot(patch_.across)).normalized(), {}, patch_.gentle + x[3], x[4], patch_.tight + x[5]};
    form.f = normal.cross(form.e);
    if (form.f.dot(patch_.along) < 0.0) form.f = -form.f;
    return patch_of(patch_.point + x[0] * patch_.normal, normal, form);
  }

 private:
  /// An equation's numbers where it has any, in ascending places.
  template <std::size_t N>
  void add(double weight, const std::array<Eigen::Index, N>& places, const std::array<double, N>& row, double wanted) {
    for (std::size_t i = 0; i < N; ++i) {
      const double weighted = weight * row[i];
      for (std::size_t k = 0; k <= i; ++k) squares_(places[i], places[k]) += weighted * row[k];
      right_[places[i]] += weight * wanted * row[i];
    }
  }

  const ToroidalPatch& patch_;
  Matrix6 squares_ = Matrix6::Zero();  // the lower half, which is all that the solver reads
  Vector6 right_ = Vector6::Zero();
};

ToroidalPatch corrected(const ToroidalPatch& patch, std::span<const WeightedSample> samples, double reach) {
  Step step(patch);
  double weights = 0.0;
  for (std::size_t j = 0; j < samples.size(); ++j) {
    const double weight = samples[j].weight * samples[j].weight * samples[j].weight;  // nearer ones decide: linear weights were 10 % worse
    const double position_weight = weight * kPositionWeight / (reach * reach) * (j == 0 ? kOwnPosition : 1.0);
    step.add(samples[j], position_weight, weight * (j == 0 ? kOwnNormal : 1.0));
    weights += weight;
  }
  return step.taken(weights * kKeepTilt, weights * kKeepCurvature * reach * reach, reach);
}

}  // namespace

ToroidalPatch fit_patch(std::span<const WeightedSample> samples, double reach) {
  const ToroidalPatch first = fit_curvatures(samples);
  return samples.size() < kFewestForCorrection ? first : corrected(first, samples, reach);
}

ToroidalPatch nearer_patch(const ToroidalPatch& patch, std::span<const WeightedSample> samples, const Variances& variances, double reach) {
  Step step(patch);
  for (const WeightedSample& sample : samples) step.add(sample, 1.0 / variances.position, 1.0 / variances.normal);
  const double flat = kKeepNoisy / variances.normal;
  return step.taken(flat, flat * reach * reach, reach);
}

}  // namespace isotouch::field
