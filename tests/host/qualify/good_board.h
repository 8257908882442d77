/// A board on which everything is well, to be spoiled by tests.
#pragma once

#include "host/qualify/figures.h"

namespace isotouch::qualify {

inline Figures good_board() {
  Figures figures;
  figures.address = "ssh://me@board";
  figures.subject = {"2026-11-26T08:30:00Z", "board",  "isotouch 1", "isotouchd 1", "1.2", "0123456789abcdef",
                     "fedcba9876543210",     "FALCON1"};
  figures.practice = {{"kernel", "kernel", "Linux 6.1 <rt>", Finding::Verdict::kBad, "It is slow.", "sudo reboot"},
                      {"governor", "frequency governor", "", Finding::Verdict::kNotRead, "There is none.", ""}};
  figures.board = {{"kernel", "Linux 6.1 <rt>"}};
  figures.seconds = 10;
  figures.ticks = 10'000;
  for (link::Histogram& histogram : figures.measures) histogram = {10'000, {{12'000, 9'000}, {40'000, 995}, {90'000, 5}}};
  Moment moment;
  moment.celsius = 55.5, moment.megahertz = 1500, moment.state = 4, moment.force = true;
  figures.moments = {moment, moment};
  figures.moments[1].second = 10;
  figures.worst = {{{77, 5'000'000'000, 90'000, 12'000}, "processor 0: kworker/0:1"}, {{78, 5'001'000'000, 80'000, 12'000}, ""}};
  figures.cold = {2'000, {{9'000, 1'900}, {30'000, 100}}};
  figures.cold_seconds = 2;
  moment.celsius = moment.megahertz = std::nullopt, moment.force = false, moment.second = 12;
  figures.later = {moment};
  figures.timer_priority = 80;
  figures.timer = {10'000, {{8'000, 9'999}, {31'000, 1}}};
  return figures;
}

}  // namespace isotouch::qualify
