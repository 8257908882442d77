#include "host/commands/felt_table.h"

#include <string>

#include "host/board_commands/quantiles_json.h"

namespace isotouch::commands {

using evaluate::FeltFigures;
using evaluate::FeltPlace;

namespace {

nlohmann::ordered_json point_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json figures_json(const FeltFigures& figures) {
  return {{"direction_deg", quantiles_json(figures.errors.direction_deg)},
          {"force_n", quantiles_json(figures.errors.force_n)},
          {"contact_differs", figures.contact_differs},
          {"jumps", figures.jumps},
          {"wrong_side", figures.wrong_side},
          {"force_without_contact", figures.force_without_contact},
          {"equal_answers", figures.equal_answers},
          {"hands", figures.hands},
          {"ticks", figures.ticks},
          {"touching", figures.touching},
          {"compared", figures.errors.direction_deg.count}};
}

nlohmann::ordered_json place_json(const FeltPlace& place) {
  return {{"kind", name_of(place.kind)},
          {"hand", place.hand},
          {"trace", place.from},
          {"tick", place.tick},
          {"hip_mm", point_json(place.hip)},
          {"god_object_mm", point_json(place.god)},
          {"proxy_mm", point_json(place.proxy)},
          {"direction_deg", place.direction_deg},
          {"force_n", place.force_n}};
}

void print_errors(std::FILE* to, const std::string& name, const evaluate::FeltErrors& errors) {
  const auto& [direction, force] = errors;
  if (direction.count == 0) {
    std::fprintf(to, "%-12s %8zu  no tick was compared\n", name.c_str(), direction.count);
    return;
  }
  std::fprintf(to, "%-12s %8zu  %6.2f %6.2f %6.2f %6.1f   %7.4f %7.4f %7.4f %7.3f\n", name.c_str(), direction.count, direction.median,
               direction.p95, direction.p99, direction.max, force.median, force.p95, force.p99, force.max);
}

void print_counts(std::FILE* to, const std::string& name, const FeltFigures& figures) {
  std::fprintf(to, "%-12s %8zu %8zu %8zu  %8zu %7zu %7zu %9zu %8zu\n", name.c_str(), figures.hands, figures.ticks, figures.touching,
               figures.contact_differs, figures.jumps, figures.wrong_side, figures.force_without_contact, figures.equal_answers);
}

void print_worst(std::FILE* to, const char* what, const FeltPlace& place) {
  std::fprintf(to, "worst %-9s %s, at (%.3f, %.3f, %.3f) mm, %.3f mm deep\n", what, words_of(place).c_str(), place.god.x(), place.god.y(),
               place.god.z(), (place.god - place.hip).norm());
}

}  // namespace

nlohmann::ordered_json felt_json(const evaluate::FeltComparison& comparison) {
  nlohmann::ordered_json kinds = nlohmann::ordered_json::object();
  for (const auto& [kind, figures] : comparison.kinds) kinds[std::string(name_of(kind))] = figures_json(figures);
  return {{"kinds", kinds},
          {"all", figures_json(comparison.all)},
          {"wrong_side_mm", comparison.wrong_side_mm},
          {"worst_direction", place_json(comparison.worst_direction)},
          {"worst_force", place_json(comparison.worst_force)}};
}

std::string words_of(const FeltPlace& place) {
  char figures[64];
  std::snprintf(figures, sizeof figures, ": %.1f°, %.3f N", place.direction_deg, place.force_n);
  return std::string(name_of(place.kind)) + (place.from.empty() ? "" : " of " + place.from) + ", hand " + std::to_string(place.hand) +
         ", tick " + std::to_string(place.tick) + figures;
}

void print_felt(std::FILE* to, const char* name, const evaluate::FeltComparison& comparison) {
  std::fprintf(to, "%-12s %8s  %27s   %31s\n", name, "", "direction, degrees        ", "force, N            ");
  std::fprintf(to, "%-12s %8s  %6s %6s %6s %6s   %7s %7s %7s %7s\n", "motion", "ticks", "median", "p95", "p99", "max", "median", "p95",
               "p99", "max");
  for (const auto& [kind, figures] : comparison.kinds) print_errors(to, std::string(name_of(kind)), figures.errors);
  print_errors(to, "all", comparison.all.errors);
  for (std::size_t r = 0; r < comparison.all.by_depth.size(); ++r) {
    char range[32];
    std::snprintf(range, sizeof range, "%.1f-%.1f mm", evaluate::kFeltDepths[r], evaluate::kFeltDepths[r + 1]);
    print_errors(to, range, comparison.all.by_depth[r]);
  }
  std::fprintf(to, "\n%-12s %8s %8s %8s  %8s %7s %7s %9s %8s\n", "", "", "", "", "contact", "", "wrong", "force, no", "equal");
  std::fprintf(to, "%-12s %8s %8s %8s  %8s %7s %7s %9s %8s\n", "motion", "hands", "ticks", "touching", "differs", "jumps", "side",
               "contact", "answers");
  for (const auto& [kind, figures] : comparison.kinds) print_counts(to, std::string(name_of(kind)), figures);
  print_counts(to, "all", comparison.all);
  std::fprintf(to, "\ncompared: 0.1 to 1 mm deep; wrong side: more than %.3f mm inside, or on the other side of a part\n",
               comparison.wrong_side_mm);
  print_worst(to, "direction", comparison.worst_direction);
  print_worst(to, "force", comparison.worst_force);
}

}  // namespace isotouch::commands
