#include "host/commands/verdict_text.h"

#include <cstdio>

namespace isotouch::commands {

namespace {

std::string per_cent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

}  // namespace

nlohmann::ordered_json to_json(const field::Verdict& verdict) {
  return {{"plausible", verdict.plausible()},
          {"reasons", verdict.reasons},
          {"noise_spacing", verdict.noise_spacing},
          {"stray_share", verdict.stray_share},
          {"turned_share", verdict.turned_share},
          {"invented_share", verdict.invented_share},
          {"gap_share", verdict.gap_share},
          {"unseen_end_share", verdict.unseen_end_share},
          {"rim_mm", verdict.rim_mm},
          {"volume_of_hull", verdict.volume_of_hull},
          {"volume_of_enclosed", verdict.volume_of_enclosed},
          {"off_surface_share", verdict.off_surface_share},
          {"contradicted_share", verdict.contradicted_share},
          {"opposed_share", verdict.opposed_share},
          {"unexplained_share", verdict.unexplained_share},
          {"surprising_share", verdict.surprising_share},
          {"thin_share", verdict.thin_share},
          {"debris_share", verdict.debris_share}};
}

std::string in_words(const field::Verdict& verdict) {
  std::string text = verdict.plausible() ? "plausible" : "probably wrong";
  text += "; noise " + per_cent(verdict.noise_spacing) + " of the spacing, " + per_cent(verdict.stray_share) + " strays, " +
          per_cent(verdict.turned_share) + " of the normals turned, " + per_cent(verdict.invented_share) + " of the surface invented";
  for (const std::string& reason : verdict.reasons) text += "\n              " + reason;
  return text;
}

nlohmann::ordered_json to_json(const live::Verdict& verdict) {
  const std::vector<std::string> reasons = verdict.reasons();
  return {{"plausible", reasons.empty()},
          {"reasons", reasons},
          {"samples", verdict.samples},
          {"lonely_share", verdict.lonely_share()},
          {"unexplained_share", verdict.unexplained_share()}};
}

std::string in_words(const live::Verdict& verdict) {
  const std::vector<std::string> reasons = verdict.reasons();
  std::string text = reasons.empty() ? "plausible" : "probably wrong";
  text += "; of " + std::to_string(verdict.samples) + " samples, " + per_cent(verdict.lonely_share()) + " have too few neighbours and " +
          per_cent(verdict.unexplained_share()) + " contradict them";
  for (const std::string& reason : reasons) text += "\n              " + reason;
  return text;
}

}  // namespace isotouch::commands
