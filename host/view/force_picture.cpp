#include "host/view/force_picture.h"

#include "host/view/caption.h"
#include "host/view/palette.h"
#include "host/view/plot.h"

namespace isotouch::view {

Image force_picture(const ForceCurve& curve, const ForceOptions& options) {
  Image image(options.width, options.height, srgb(0xFBFCFD));
  Canvas canvas(image);
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const float air = 8 * drawing_scale(image);

  Plot force;
  force.title = options.title;
  force.x_label = "time (s)";
  force.y_label = "force (N)";
  force.series.push_back({"as the core renders it", curve.time_s, curve.felt_n, kBlue, 2.4F});
  if (curve.exact_n.empty()) {
    force.draw(canvas, {0, air, width, height - air});
    return image;
  }
  force.series.push_back({options.exact_label, curve.time_s, curve.exact_n, kForceColour, 1.3F, true});

  Series difference{"", curve.time_s, {}, kVermilion, 1.5F};
  for (std::size_t i = 0; i < curve.felt_n.size(); ++i) difference.y.push_back(1000 * (curve.felt_n[i] - curve.exact_n[i]));
  Plot error;
  error.title = "difference to the exact answer";
  error.x_label = "time (s)";
  error.y_label = "difference (mN)";
  error.series.push_back(std::move(difference));
  const float middle = height * 0.6F;
  force.draw(canvas, {0, air, width, middle});
  error.draw(canvas, {0, middle, width, height - air});
  return image;
}

}  // namespace isotouch::view
