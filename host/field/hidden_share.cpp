#include "host/field/hidden_share.h"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field/nearest.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 17;  // in the nearest directions, itself among them
constexpr std::size_t kHiding = 7;  // of them; beside narrow shadows six of them may lie in front
constexpr double kInFront = 1.0;    // spacings before the tangent plane

}  // namespace

double hidden_share(const Scan& scan, const Vector3d& eye) {
  std::vector<Vector3d> directions(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) directions[i] = (scan.positions()[i] - eye).normalized();
  const Nearest tree(directions);
  std::atomic<std::size_t> hidden{0};
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> beside;
    for (const std::uint32_t i : scan.together(begin, end)) {
      const double least = kInFront * scan.spacing(i);
      const double side = scan.normals()[i].dot(directions[i]) > 0.0 ? -1.0 : 1.0;
      std::size_t hiding = 0;
      tree.nearest(directions[i], kAsked, beside);
      for (const Neighbour& n : beside) {
        const Vector3d step = scan.positions()[n.index] - scan.positions()[i];
        if (step.dot(directions[i]) < 0.0 && side * step.dot(scan.normals()[i]) > least) ++hiding;
      }
      if (hiding >= kHiding) ++hidden;
    }
  });
  return static_cast<double>(hidden) / static_cast<double>(scan.size());
}

}  // namespace isotouch::field
