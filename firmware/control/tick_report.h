/// What the loop counted, as messages of the wire.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/control/worst_ticks.h"
#include "firmware/loop/tick_record.h"
#include "firmware/loop/tick_stats.h"
#include "shared/wire_messages.h"

namespace isotouch::control {

/// newest      the last tick that was shown
/// field_hash  of the field handed to the tick last
wire::StatusReport status_report(const loop::TickRecord& newest, const loop::TickStats& stats, std::uint64_t field_hash);

/// scratch     holds the bins that the report borrows; `kHistogramScratch` bytes are enough
/// returns     the filled classes of one histogram
wire::HistogramReport histogram_report(wire::Measure measure, const loop::TickStats& stats, std::span<std::uint8_t> scratch);
inline constexpr std::size_t kHistogramScratch = loop::histogram_layout::kBuckets * wire::kBinBytes;
static_assert(kHistogramScratch + 64 <= wire::kMaxBody);

/// scratch     as above
wire::WorstTicks worst_report(const WorstTicks& worst, std::span<std::uint8_t> scratch);

}  // namespace isotouch::control
