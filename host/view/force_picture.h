/// Force over time, beside the exact answer where there is one: the paper's Fig. 9.
#pragma once

#include <string>
#include <vector>

#include "host/view/image.h"

namespace isotouch::view {

/// Magnitudes in newtons. Without an exact answer `exact_n` is empty.
struct ForceCurve {
  std::vector<double> time_s;
  std::vector<double> felt_n;
  std::vector<double> exact_n;
};

struct ForceOptions {
  int width = 960, height = 720;
  std::string title = {};
  std::string exact_label = "exact";
};

/// With an exact answer a second plot shows the difference in millinewtons.
Image force_picture(const ForceCurve& curve, const ForceOptions& options);

}  // namespace isotouch::view
