/// Measures a board through its controller and a shell on it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host/qualify/figures.h"
#include "host/qualify/practice.h"

namespace isotouch::qualify {

struct Wish {
  double seconds = 60;          ///< of the ticks, and of cyclictest after them
  double cold_seconds = 10;     ///< of the ticks while other programs write to memory, at most `seconds`; 0: not measured
  std::optional<int> priority;  ///< of cyclictest; 0: it is not run; none: as `timer_priority` returns it
  double wakeup_us = 0;         ///< the largest wake-up delay that is good, as `Limits` has it; 0: a tenth of the period
  bool trace = true;            ///< ask the kernel's tracer for causes
  std::function<bool()> is_over = [] { return false; };  ///< asked again and again: it is to end before its time
};

/// The priority of cyclictest: the one that is wished for, else the tick's own, or 80 if the tick's is not seen or not that of a real-time thread.
int timer_priority(std::optional<int> wished, const BoardFiles& files);

/// The ticks first, undisturbed; then with cold caches; then cyclictest beside them.
///
/// address   as host/link/address.h
/// tell      what happens now, for people
/// returns   figures that are cut, where it was to end, or the controller was lost, before all of it was measured
/// fails     InputError: not even the first second was measured
Figures measure(const std::string& address, const Wish& wish, const std::function<void(const std::string&)>& tell);

}  // namespace isotouch::qualify
