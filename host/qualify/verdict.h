/// Is this board fit to render forces? Each limit is judged on its own; one that is missed makes the board unfit, one that could not be measured is said.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/qualify/figures.h"

namespace isotouch::qualify {

/// The largest values that are good. The defaults are for people's hands: a late tick or a page fault is a force that stumbles.
struct Limits {
  double late_ticks = 0;        ///< undisturbed, and while other programs use the caches
  double wakeup_us = 0;         ///< 99.9 % of the wake-ups; 0: a tenth of the period
  double round_trip_us = 2500;  ///< 99.9 % of the device's: a Falcon answers in a frame of USB, 1 ms, or in the next
  double word_ticks = 1;        ///< sensor to command, all of them: commands are made of the newest sample
  double lost_samples = 1;      ///< of a hundred expected ones, one a tick or, where ticks are faster, one a millisecond
  double celsius = 75;          ///< most boards slow down at 80
  double page_faults = 0;       ///< to the end of the measurement, as the next
  double allocations = 0;
  double left_out =
      1;              ///< of a hundred expected ticks, those that did not come: undisturbed or with others at the caches, whichever is more
  double faults = 0;  ///< looks that saw the controller in fault, to the end of the measurement
  double cold_tick_us = 0;  ///< 99 % of the ticks while other programs use the caches; 0: a tenth of the period
  double inactive = 50;     ///< of a hundred looks, those that saw no force: what gives no force proves little
};

/// The limit of what is late, unless it is set.
///
/// returns   us
double tenth_of_period_us(std::uint32_t period_ns);

struct Judgement {
  enum class Outcome { kMet, kMissed, kNotMeasured };

  std::string key;   ///< for programs
  std::string what;  ///< for people
  std::string unit;
  double limit = 0;
  double value = 0;  ///< 0 where it was not measured
  Outcome outcome = Outcome::kNotMeasured;
  bool is_lost = false;  ///< not measured, though the board could: then it is not fit
};

/// A value is good up to its limit.
///
/// value     none: it was not measured
Judgement judged(std::string key, std::string what, std::string unit, double limit, std::optional<double> value);

/// returns   one judgement for each limit, always in the same order
std::vector<Judgement> judge(const Figures& figures, const Limits& limits);

/// No limit is missed or lost, commands were made of a device's samples, and the controller could be asked to the end. Both of these must be among the
/// judgements.
bool is_fit(const std::vector<Judgement>& judgements);

/// "fit", "not fit"
const char* verdict(const std::vector<Judgement>& judgements);

/// The verdict in one sentence.
std::string sentence(const std::vector<Judgement>& judgements);

/// For programs: "met", "missed", "not measured".
const char* name_of(Judgement::Outcome outcome);

/// For people: "kept", "exceeded", "not measured".
const char* in_words(Judgement::Outcome outcome);

}  // namespace isotouch::qualify
