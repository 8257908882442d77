#include <nlohmann/json.hpp>

#include "host/qualify/report.h"
#include "shared/files/state_text.h"

namespace isotouch::qualify {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const link::Histogram& histogram, double unit_ns) {
  Json bins = Json::array();
  for (const protocol::Bin& bin : histogram.bins) bins.push_back({{"up_to", bin.upper / unit_ns}, {"count", bin.count}});
  Json json{{"count", histogram.count}};
  for (const auto& [name, share] : {std::pair{"p50", 0.5}, std::pair{"p99", 0.99}, std::pair{"p999", 0.999}, std::pair{"max", 1.0}}) {
    const auto ns = quantile_ns(histogram, share);
    json[name] = ns ? Json(*ns / unit_ns) : Json();
  }
  json["bins"] = bins;
  return json;
}

}  // namespace

MeasureText text_of(protocol::Measure measure) {
  switch (measure) {
    case protocol::Measure::kWakeup: return {"wakeup_us", "Wake-up: how late a tick begins", "us"};
    case protocol::Measure::kTick: return {"tick_us", "Tick: from its begin to its motor commands", "us"};
    case protocol::Measure::kRoundTrip: return {"round_trip_us", "USB round trip: from motor commands to the reply", "us"};
    case protocol::Measure::kDelay: break;
  }
  return {"delay_ticks", "Sensor to motor command: from a reply to the motor commands made from it", "ticks"};
}

Json json_report(const Figures& figures, const std::vector<Judgement>& judgements) {
  Json json{{"verdict", verdict(judgements)}, {"sentence", sentence(judgements)}, {"limits", Json::array()}};
  for (const Judgement& j : judgements) {
    const bool known = j.outcome != Judgement::Outcome::kNotMeasured;
    json["limits"].push_back(
        {{"key", j.key}, {"unit", j.unit}, {"limit", j.limit}, {"value", known ? Json(j.value) : Json()}, {"outcome", name_of(j.outcome)}});
  }
  json["address"] = figures.address;
  const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  const Subject& subject = figures.subject;
  json["program"] = subject.controller;
  json["date"] = subject.date;
  json["host"] = or_null(subject.host);
  json["versions"] = {{"isotouch", subject.tool}, {"controller", subject.controller}, {"protocol", subject.protocol}};
  json["field"] = or_null(subject.field);
  json["settings_checksum"] = subject.settings;
  json["device"] = or_null(subject.device);
  for (const auto& [name, value] : figures.board) json["board"][name] = value;
  json["practice"] = Json::array();
  for (const Finding& f : figures.practice) {
    json["practice"].push_back(
        {{"key", f.key}, {"read", or_null(f.read)}, {"verdict", name_of(f.verdict)}, {"why", f.why}, {"remedy", or_null(f.remedy)}});
  }
  if (!figures.practice_unknown.empty()) json["practice_unknown"] = figures.practice_unknown;
  json["period_us"] = figures.period_ns / 1000.0;
  json["seconds"] = figures.seconds;
  json["ticks"] = figures.ticks;
  json["late"] = figures.late;
  json["page_faults"] = figures.page_faults;
  json["allocations"] = figures.allocations;
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const MeasureText text = text_of(static_cast<protocol::Measure>(i));
    const bool in_ticks = static_cast<protocol::Measure>(i) == protocol::Measure::kDelay;
    json[text.key] = json_of(figures.measures[i], in_ticks ? figures.period_ns : 1000.0);
  }
  json["cold_tick_us"] = figures.cold.count > 0 ? json_of(figures.cold, 1000.0) : Json{{"unknown", figures.cold_unknown}};
  json["cold_seconds"] = figures.cold_seconds;
  json["cold_late"] = figures.cold_late;
  json["cyclictest_priority"] = figures.timer_priority;
  json["cyclictest_us"] = figures.timer.count > 0 ? json_of(figures.timer, 1000.0) : Json{{"unknown", figures.timer_unknown}};
  if (figures.timer.count > 0 && !figures.timer_unknown.empty()) json["cyclictest_unknown"] = figures.timer_unknown;
  json["worst_ticks"] = Json::array();
  for (const WorstTick& worst : figures.worst) {
    json["worst_ticks"].push_back({{"tick", worst.tick.number},
                                   {"wakeup_us", worst.tick.wake_ns / 1000.0},
                                   {"tick_us", worst.tick.tick_ns / 1000.0},
                                   {"cause", worst.cause.empty() ? Json() : Json(worst.cause)}});
  }
  if (!figures.cause_unknown.empty()) json["causes_unknown"] = figures.cause_unknown;
  if (!figures.sensors_unknown.empty()) json["sensors_unknown"] = figures.sensors_unknown;
  json["moments"] = Json::array();
  for (const std::vector<Moment>* looks : {&figures.moments, &figures.later}) {
    for (const Moment& m : *looks) {
      json["moments"].push_back({{"second", m.second},
                                 {"celsius", m.celsius ? Json(*m.celsius) : Json()},
                                 {"megahertz", m.megahertz ? Json(*m.megahertz) : Json()},
                                 {"late", m.late},
                                 {"page_faults", m.page_faults},
                                 {"allocations", m.allocations},
                                 {"state", files::state_name(m.state)},
                                 {"force", m.force}});
    }
  }
  return json;
}

}  // namespace isotouch::qualify
