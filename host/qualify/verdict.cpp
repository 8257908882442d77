#include "host/qualify/verdict.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "shared/tick_io.h"

namespace isotouch::qualify {

namespace {

using Outcome = Judgement::Outcome;

std::optional<double> quantile(const Figures& figures, protocol::Measure measure, double share, double unit_ns) {
  const auto ns = quantile_ns(figures.measures[static_cast<std::size_t>(measure)], share);
  return ns ? std::optional(*ns / unit_ns) : std::nullopt;
}

constexpr double kSamplesPerSecond = 1000;  // at most, of a Falcon

/// Of a hundred expected samples, those that no tick has seen. Every fresh one left its round trip.
std::optional<double> lost_samples(const Figures& figures) {
  const double expected = std::min(static_cast<double>(figures.ticks), figures.seconds * kSamplesPerSecond);
  if (expected <= 0) return std::nullopt;
  const auto seen = static_cast<double>(figures.measures[static_cast<std::size_t>(protocol::Measure::kRoundTrip)].count);
  return std::max(0.0, 100 * (expected - seen) / expected);
}

/// How many looks saw the controller in this state; nothing when nobody looked.
std::optional<double> looks_in(SupervisorState state, const std::vector<Moment>& moments) {
  if (moments.empty()) return std::nullopt;
  const auto in_state = [=](const Moment& moment) { return moment.state == static_cast<std::uint16_t>(state); };
  return static_cast<double>(std::count_if(moments.begin(), moments.end(), in_state));
}

std::optional<double> faults(const Figures& figures) {
  const auto first = looks_in(SupervisorState::kFault, figures.moments);
  if (!first || !figures.end_unknown.empty()) return std::nullopt;  // a controller that cannot be asked may be in any state
  return *first + looks_in(SupervisorState::kFault, figures.later).value_or(0);
}

std::optional<double> without_force(const std::vector<Moment>& moments) {
  if (moments.empty()) return std::nullopt;
  const auto count = std::count_if(moments.begin(), moments.end(), [](const Moment& moment) { return !moment.force; });
  return 100 * static_cast<double>(count) / static_cast<double>(moments.size());
}

/// A board that could not be asked at each look may have been hotter, but not cooler.
Judgement temperature(const Figures& figures, double limit) {
  const auto most = hottest(figures.moments);
  const bool is_lost = !figures.sensors_unknown.empty() && !(most && *most > limit);
  Judgement judgement = judged("celsius_max", "highest temperature", "°C", limit, is_lost ? std::nullopt : most);
  judgement.is_lost = is_lost;
  return judgement;
}

/// Of a hundred expected ticks, those that did not come.
double left_out(std::uint64_t ticks, double seconds, std::uint32_t period_ns) {
  const double expected = seconds * 1e9 / period_ns;
  return expected > 0 ? std::max(0.0, 100 * (expected - static_cast<double>(ticks)) / expected) : 100;
}

/// Of the part with the larger share.
double left_out(const Figures& figures) {
  const double first = left_out(figures.ticks, figures.seconds, figures.period_ns);
  return figures.cold_seconds > 0 ? std::max(first, left_out(figures.cold.count, figures.cold_seconds, figures.period_ns)) : first;
}

}  // namespace

double tenth_of_period_us(std::uint32_t period_ns) { return period_ns / 10'000.0; }

Judgement judged(std::string key, std::string what, std::string unit, double limit, std::optional<double> value) {
  const Outcome outcome = !value ? Outcome::kNotMeasured : *value <= limit ? Outcome::kMet : Outcome::kMissed;
  return {std::move(key), std::move(what), std::move(unit), limit, value.value_or(0), outcome};
}

std::vector<Judgement> judge(const Figures& figures, const Limits& limits) {
  const auto counted = [&](std::uint64_t count) { return figures.ticks > 0 ? std::optional(static_cast<double>(count)) : std::nullopt; };
  const Moment end = figures.later.empty() ? Moment{} : figures.later.back();
  const double wakeup_us = limits.wakeup_us > 0 ? limits.wakeup_us : tenth_of_period_us(figures.period_ns);
  const double cold_us = limits.cold_tick_us > 0 ? limits.cold_tick_us : tenth_of_period_us(figures.period_ns);
  const auto cold_ns = quantile_ns(figures.cold, 0.99);
  return {
      judged("left_out", "ticks that did not come", "%", limits.left_out, left_out(figures)),
      judged("late_ticks", "late ticks", "", limits.late_ticks, counted(figures.late + figures.cold_late)),
      judged("wakeup_p999_us", "99.9 % of wake-ups", "us", wakeup_us, quantile(figures, protocol::Measure::kWakeup, 0.999, 1000)),
      judged("round_trip_p999_us", "99.9 % of round trips", "us", limits.round_trip_us,
             quantile(figures, protocol::Measure::kRoundTrip, 0.999, 1000)),
      judged("word_max_ticks", "longest sensor to motor command", "ticks", limits.word_ticks,
             quantile(figures, protocol::Measure::kDelay, 1, figures.period_ns)),
      judged("lost_samples", "samples that did not come", "%", limits.lost_samples, lost_samples(figures)),
      temperature(figures, limits.celsius),
      judged("page_faults", "page faults of the tick", "", limits.page_faults, counted(std::max(figures.page_faults, end.page_faults))),
      judged("allocations", "allocations of the tick", "", limits.allocations, counted(std::max(figures.allocations, end.allocations))),
      judged("faults", "checks that find a fault", "", limits.faults, faults(figures)),
      judged("inactive", "checks that find no force", "%", limits.inactive, without_force(figures.moments)),
      judged("cold_tick_p99_us", "99 % of cold ticks", "us", cold_us, cold_ns ? std::optional(*cold_ns / 1000.0) : std::nullopt),
  };
}

bool is_fit(const std::vector<Judgement>& judgements) {
  const auto is_measured = [&](std::string_view key) {
    return std::any_of(judgements.begin(), judgements.end(),
                       [&](const Judgement& j) { return j.key == key && j.outcome != Outcome::kNotMeasured; });
  };
  const bool missed =
      std::any_of(judgements.begin(), judgements.end(), [](const Judgement& j) { return j.outcome == Outcome::kMissed || j.is_lost; });
  // Without a device, commands and round trips were never made: nothing is known of what matters most.
  return !missed && is_measured("word_max_ticks") && is_measured("faults");
}

const char* verdict(const std::vector<Judgement>& judgements) { return is_fit(judgements) ? "fit" : "not fit"; }

std::string sentence(const std::vector<Judgement>& judgements) {
  const auto names = [&](Outcome outcome) {
    std::string text;
    for (const Judgement& j : judgements) {
      if (j.outcome == outcome) text += (text.empty() ? "" : ", ") + j.what;
    }
    return text;
  };
  const std::string missed = names(Outcome::kMissed), unknown = names(Outcome::kNotMeasured);
  std::string text = verdict(judgements);
  if (!missed.empty()) text += "; beyond the limit: " + missed;
  if (!unknown.empty()) text += "; not measured: " + unknown;
  return text;
}

const char* in_words(Outcome outcome) {
  return outcome == Outcome::kMet ? "kept" : outcome == Outcome::kMissed ? "exceeded" : "not measured";
}

const char* name_of(Outcome outcome) { return outcome == Outcome::kMet ? "met" : outcome == Outcome::kMissed ? "missed" : "not measured"; }

}  // namespace isotouch::qualify
