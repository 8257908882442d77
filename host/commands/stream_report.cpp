#include "host/commands/stream_report.h"

#include "host/board_commands/controller_options.h"
#include "host/board_commands/quantiles_json.h"
#include "host/commands/verdict_text.h"

namespace isotouch::commands {

void print_second(double now, std::uint64_t thinned, std::uint64_t lost, const std::string& silent, const stream::Tally& of,
                  const std::string& fault) {
  const Quantiles delay = of.delay_ms.quantiles();
  std::fprintf(stderr, "%.0f s: %llu frames, %llu left out, %zu points, %zu not needed, %zu outside", now,
               static_cast<unsigned long long>(of.frames), static_cast<unsigned long long>(thinned), of.points.taken, of.points.surplus,
               of.points.outside);
  if (of.unoriented > 0) std::fprintf(stderr, ", %llu frames without normals", static_cast<unsigned long long>(of.unoriented));
  if (lost > 0) std::fprintf(stderr, ", %llu ticks of the hand lost", static_cast<unsigned long long>(lost));
  if (of.patches > 0) std::fprintf(stderr, ", %llu patches", static_cast<unsigned long long>(of.patches));
  if (delay.count > 0) std::fprintf(stderr, ", delay %.1f ms, at most %.1f ms", delay.median, delay.max);
  if (of.refused_s > 0) std::fprintf(stderr, "; for %.1f s the controller refused a patch: %s", of.refused_s, of.refusal.c_str());
  if (!silent.empty()) std::fprintf(stderr, "; %s is silent", silent.c_str());
  if (of.unanswered) std::fprintf(stderr, "; still waiting for the controller");
  if (!fault.empty()) std::fprintf(stderr, "; the state is %s", fault.c_str());
  std::fprintf(stderr, "\n");
}

nlohmann::ordered_json summary_json(const stream::Stream& of, const std::string& field_hash) {
  const stream::StreamReport& report = of.report();
  const stream::Tally& all = report.all;
  return {{"seconds", report.seconds},
          {"frames",
           {{"arrived", report.offered},
            {"taken", all.frames},
            {"thinned", report.thinned},
            {"empty", all.empty},
            {"without_normals", all.unoriented}}},
          {"points",
           {{"taken", all.points.taken},
            {"outside", all.points.outside},
            {"useless", all.points.useless},
            {"surplus", all.points.surplus},
            {"expired", all.points.expired},
            {"present", all.points.taken - all.points.expired}}},
          {"lost_ticks", report.lost},
          {"refused_seconds", all.refused_s},
          {"upload_bytes", report.upload_bytes},
          {"patches", all.patches},
          {"patch_bytes", quantiles_json(report.patch_bytes.quantiles())},
          {"sent_bytes", report.upload_bytes + all.patch_bytes},
          {"fault", of.fault()},
          {"delay_ms", quantiles_json(all.delay_ms.quantiles())},
          {"read_ms", quantiles_json(report.read_ms.quantiles())},
          {"grow_ms", quantiles_json(report.grow_ms.quantiles())},
          {"patch_ms", quantiles_json(report.patch_ms.quantiles())},
          {"controller_ms", quantiles_json(report.controller_ms.quantiles())},
          {"field_hash", field_hash},
          {"live_verdict", to_json(of.field()->verdict())}};
}

void print_summary(const stream::Stream& of, const std::string& field_hash, bool is_sent, std::FILE* to) {
  const stream::StreamReport& report = of.report();
  const stream::Tally& all = report.all;
  std::fprintf(to, "frames        %llu in %.1f s: %llu taken, %llu left out, %llu empty, %llu without normals\n",
               static_cast<unsigned long long>(report.offered), report.seconds, static_cast<unsigned long long>(all.frames),
               static_cast<unsigned long long>(report.thinned), static_cast<unsigned long long>(all.empty),
               static_cast<unsigned long long>(all.unoriented));
  std::fprintf(to, "points        %zu taken, %zu not needed, %zu outside the box, %zu without a normal, %zu expired\n", all.points.taken,
               all.points.surplus, all.points.outside, all.points.useless, all.points.expired);
  if (report.lost > 0)
    std::fprintf(to, "lost          %llu ticks of the hand, for which the link or the controller was too slow\n",
                 static_cast<unsigned long long>(report.lost));
  const auto& [scale, offset] = of.space().placement;
  std::fprintf(to, "transform     workspace mm = %.9g · input + (%.9g, %.9g, %.9g)\n", scale, offset.x(), offset.y(), offset.z());
  const field::Grid& grid = of.space().grid;
  std::fprintf(to, "grid          %d × %d × %d samples, voxel %.4f mm\n", grid.size.x(), grid.size.y(), grid.size.z(), grid.edge);
  std::fprintf(to, "verdict       %s\n", in_words(of.field()->verdict()).c_str());
  if (is_sent) {
    const Quantiles delay = all.delay_ms.quantiles(), bytes = report.patch_bytes.quantiles();
    std::fprintf(to, "sent          %llu bytes for the first field, %llu patches of %.0f bytes (99 %% at most %.0f)\n",
                 static_cast<unsigned long long>(report.upload_bytes), static_cast<unsigned long long>(all.patches), bytes.median,
                 bytes.p99);
    if (delay.count > 0)
      std::fprintf(to, "delay         %.1f ms from a frame to the hand, 99 %% at most %.1f ms, the longest %.1f ms\n", delay.median,
                   delay.p99, delay.max);
    if (!of.fault().empty()) std::fprintf(to, "state         %s\n", of.fault().c_str());
    if (all.refused_s > 0) std::fprintf(to, "refused       patches for %.1f s, which the delay counts\n", all.refused_s);
  }
  std::fprintf(to, "field         hash %s\n", field_hash.c_str());
}

}  // namespace isotouch::commands
