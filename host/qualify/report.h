/// A qualification as a page for people and as an object for programs: the same figures.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/qualify/figures.h"
#include "host/qualify/verdict.h"

namespace isotouch::qualify {

/// Names of what a controller measures, and its unit for people.
struct MeasureText {
  const char* key;
  const char* title;
  const char* unit;  ///< "us" or "ticks"
};
MeasureText text_of(protocol::Measure measure);

nlohmann::ordered_json json_report(const Figures& figures, const std::vector<Judgement>& judgements);

/// One file without scripts and without anything from elsewhere.
std::string html_report(const Figures& figures, const std::vector<Judgement>& judgements);

}  // namespace isotouch::qualify
