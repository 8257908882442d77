#include "host/field/scan.h"

#include <algorithm>
#include <utility>

#include "host/field/parallel.h"

namespace isotouch::field {

Scan::Scan(cloud::OrientedPoints points)
    : points_(std::move(points)), tree_(points_.positions), listed_(std::min(kListed, points_.size())), lists_(listed_ * points_.size()) {
  in_parallel(size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    for (const std::uint32_t i : together(begin, end)) {
      tree_.nearest(positions()[i], listed_, found);
      std::copy(found.begin(), found.end(), lists_.begin() + static_cast<std::ptrdiff_t>(i * listed_));
    }
  });
}

double Scan::median_spacing() const {
  std::vector<double> spacings(size());
  for (std::size_t i = 0; i < size(); ++i) spacings[i] = spacing(i);
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

}  // namespace isotouch::field
