#include "firmware/guard/encoder_watch.h"

#include <algorithm>
#include <cstdlib>

namespace isotouch::guard {

namespace {

constexpr int kStop = 3;   // counts by which a stop gives way
constexpr int kLeap = 60;  // counts from packet to packet: no hand is that fast, so another leg has lost its place

void widen(EncoderMemory::Span& span, const EncoderMemory::Counts& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    span.low[i] = std::min(span.low[i], counts[i]);
    span.high[i] = std::max(span.high[i], counts[i]);
  }
}

bool may_be_at_its_stop(const EncoderMemory& memory, std::size_t leg) {
  return memory.counts[leg] <= memory.ends.low[leg] + kStop || memory.counts[leg] >= memory.ends.high[leg] - kStop;
}

}  // namespace

void follow_counts(const std::array<std::int16_t, 3>& counts, bool referenced, EncoderMemory& memory) {
  if (!referenced || !memory.begun) {
    memory = {};
    memory.begun = referenced;
    memory.counts = memory.ends.low = memory.ends.high = counts;
    memory.at_rest.fill(memory.ends);
    return;
  }
  widen(memory.ends, counts);
  bool leaps = false;
  for (std::size_t i = 0; i < counts.size(); ++i) leaps |= std::abs(counts[i] - memory.counts[i]) > kLeap;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (leaps || counts[i] != memory.counts[i]) memory.at_rest[i] = {counts, counts};
    widen(memory.at_rest[i], counts);
  }
  memory.still = counts == memory.counts ? memory.still + 1 : 0;
  if (memory.still == 0) memory.has_force = false, memory.changed_at = 0;
  memory.counts = counts;
}

void follow_force(const Point& force, EncoderMemory& memory) {
  if (!memory.has_force) {
    memory.has_force = true;
    memory.force = force;
  }
  const bool changed = length(force - memory.force) > kStuckForce;
  memory.changed_at = !changed ? 0 : memory.changed_at == 0 ? std::max(memory.still, 1U) : memory.changed_at;
}

bool is_stuck(const EncoderMemory& memory) {
  bool one = false, stops = false;
  for (std::size_t i = 0; i < memory.counts.size(); ++i) {
    const EncoderMemory::Span& others = memory.at_rest[i];
    int travel = 0;
    for (std::size_t j = 0; j < memory.counts.size(); ++j) travel = std::max(travel, others.high[j] - others.low[j]);
    const bool stop = may_be_at_its_stop(memory, i);
    one |= travel > kStuckTravel && !stop;
    stops |= stop;
  }
  return one || (!stops && memory.changed_at != 0 && memory.still >= memory.changed_at + kStuckPackets);
}

}  // namespace isotouch::guard
