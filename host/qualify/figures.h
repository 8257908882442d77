/// What was measured of a board, complete and by value: what the verdict judges and the reports show.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/link/controller.h"
#include "host/qualify/practice.h"
#include "shared/protocol_messages.h"

namespace isotouch::qualify {

/// One look during the measurement.
struct Moment {
  double second = 0;                ///< since the measurement began
  std::optional<double> celsius;    ///< the hottest of the board's sensors
  std::optional<double> megahertz;  ///< of the slowest processor
  std::uint64_t late = 0;           ///< ticks since the measurement began
  std::uint64_t page_faults = 0;    ///< of the tick, since then
  std::uint64_t allocations = 0;    ///< of the tick, since then
  std::uint16_t state = 0;          ///< SupervisorState
  bool force = false;               ///< from this look to the next, a tick was seen that was active and in contact
};

struct WorstTick {
  protocol::WorstTick tick;
  std::string cause;  ///< what the processor did instead; empty: unknown
};

/// What a report is about, so that two of them can be compared.
struct Subject {
  std::string date;        ///< UTC at the begin, as 2026-11-26T08:30:00Z
  std::string host;        ///< name of the board
  std::string tool;        ///< name, version and commit of this program
  std::string controller;  ///< the same of the controller, as it gives them
  std::string protocol;    ///< version that both speak
  std::string field;       ///< hash of the image that was felt at the end, 16 hexadecimal digits; empty: none
  std::string settings;    ///< checksum of the controller's settings, as `isotouch status` shows it
  std::string device;      ///< serial number; empty: none answers, or it has none
};

struct Figures {
  std::string address;
  Subject subject;
  std::vector<std::pair<std::string, std::string>> board;  ///< name and value of what describes it
  std::uint32_t period_ns = 1'000'000;                     ///< of a tick
  double seconds = 0;                                      ///< that the ticks were measured for

  // All of these belong to that time alone.
  std::uint64_t ticks = 0, late = 0, page_faults = 0, allocations = 0;
  std::array<link::Histogram, protocol::kMeasures> measures;
  std::vector<Moment> moments;
  std::string sensors_unknown;   ///< one sentence why some of them have no sensors; empty: all were read, or the board has none
  std::vector<WorstTick> worst;  ///< the latest commands first
  std::string cause_unknown;     ///< one sentence why causes are not known

  std::vector<Finding> practice;  ///< what the board does for or against ticks in time
  std::string practice_unknown;   ///< one sentence why there are none

  link::Histogram cold;         ///< ticks while other programs wrote to memory; ns
  double cold_seconds = 0;      ///< that they wrote for; 0: not measured
  std::uint64_t cold_late = 0;  ///< late ticks of that time, also where it was cut short
  std::string cold_unknown;     ///< one sentence why there are none

  link::Histogram timer;      ///< cyclictest's wake-ups; ns
  int timer_priority = 0;     ///< of cyclictest under SCHED_FIFO
  std::string timer_unknown;  ///< one sentence why there are none, or only those until it ended before its time

  std::vector<Moment> later;  ///< looks after the cold ticks and after each piece of cyclictest, without sensors
  std::string end_unknown;    ///< one sentence why the measurement ended before its time; empty: it did not

  bool is_cut() const { return !end_unknown.empty(); }
};

/// What came between two readings of a histogram that only grows.
link::Histogram between(const link::Histogram& before, const link::Histogram& after);

/// Both counts in one, by rising bounds.
link::Histogram sum(const link::Histogram& one, const link::Histogram& other);

/// The bound of a class that `share` of all values do not exceed; nothing when there are no values.
///
/// share     0 to 1; 1: the largest value's class
std::optional<std::uint32_t> quantile_ns(const link::Histogram& histogram, double share);

/// The highest temperature of all looks; nothing when the board has no sensor.
std::optional<double> hottest(const std::vector<Moment>& moments);

}  // namespace isotouch::qualify
