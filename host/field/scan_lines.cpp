#include "host/field/scan_lines.h"

#include <Eigen/Eigenvalues>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kAsked = 7;  // of a sample's list, itself among them
constexpr double kNarrow = 0.2;    // width of a line over its length, both as standard deviations

}  // namespace

double share_in_lines(const Scan& scan) {
  std::atomic<std::size_t> lines{0};
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (const std::uint32_t i : scan.together(begin, end)) {
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (const Neighbour& n : scan.around(i, kAsked)) {
        const Eigen::Vector3d step = scan.positions()[n.index] - scan.positions()[i];
        spread += step * step.transpose();
      }
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(spread, Eigen::EigenvaluesOnly);
      here += solver.eigenvalues()[1] < kNarrow * kNarrow * solver.eigenvalues()[2] ? 1U : 0U;
    }
    lines += here;
  });
  return static_cast<double>(lines) / static_cast<double>(scan.size());
}

}  // namespace isotouch::field
