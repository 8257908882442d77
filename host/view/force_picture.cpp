#include "host/view/force_picture.h"

#include <algorithm>

#include "host/view/caption.h"
#include "host/view/palette.h"
#include "host/view/plot.h"

namespace isotouch::view {

namespace {

std::vector<double> magnitudes(const ForceCurve& curve) {
  std::vector<double> newtons;
  for (const Eigen::Vector3d& force : curve.force) newtons.push_back(force.norm());
  return newtons;
}

}  // namespace

std::vector<double> force_differences(const ForceCurve& felt, const ForceCurve& beside) {
  std::vector<double> millinewtons;
  for (std::size_t i = 0; i < std::min(felt.force.size(), beside.force.size()); ++i) {
    millinewtons.push_back(1000 * (felt.force[i] - beside.force[i]).norm());
  }
  return millinewtons;
}

Picture force_picture(const ForceCurve& felt, const ForceCurve* beside, const ForceOptions& options) {
  Picture picture(options.width, options.height, srgb(0xFBFCFD));
  Canvas canvas(picture);
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const float air = 8 * drawing_scale(picture);

  Plot force;
  force.title = options.title;
  force.x_label = "time (s)";
  force.y_label = "force (N)";
  force.bands = options.contacts;
  if (!options.contacts.empty()) force.band_label = "contact";
  force.series.push_back({felt.label, felt.time_s, magnitudes(felt), kBlue, 2.4F});
  if (beside != nullptr) force.series.push_back({beside->label, beside->time_s, magnitudes(*beside), kForceColour, 1.3F, true});
  if (!options.limits_n.empty()) {
    double most = 0;
    for (const Series& series : force.series) {
      for (const double n : series.y) most = std::max(most, n);
    }
    const auto [least, largest] = std::ranges::minmax(options.limits_n);
    if (least != largest || most > 0.5 * least) {
      Series limit{"limit", felt.time_s, options.limits_n, kVermilion, 1.5F, true};
      if (beside != nullptr && beside->time_s.size() > limit.x.size()) {  // the last one holds on
        limit.x = beside->time_s;
        limit.y.resize(limit.x.size(), limit.y.back());
      }
      force.series.push_back(std::move(limit));
    } else {
      force.title += (force.title.empty() ? "limit " : "; limit ") + number(least, 3) + " N";
    }
  }
  if (beside == nullptr) {
    force.draw(canvas, {0, air, width, height - air});
    return picture;
  }

  Series difference{"", felt.time_s, force_differences(felt, *beside), kVermilion, 1.5F};
  difference.x.resize(difference.y.size());
  Plot error;
  error.title = options.difference;
  error.x_label = "time (s)";
  error.y_label = "difference (mN)";
  error.series.push_back(std::move(difference));
  const float middle = height * 0.6F;
  force.draw(canvas, {0, air, width, middle});
  error.draw(canvas, {0, middle, width, height - air});
  return picture;
}

}  // namespace isotouch::view
