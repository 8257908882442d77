/// What the loop counted, as messages of the protocol.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/control/worst_ticks.h"
#include "firmware/loop/tick_record.h"
#include "firmware/loop/tick_stats.h"
#include "firmware/store/field_intake.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

/// newest    the last tick that was shown
/// field     handed to the tick last
protocol::StatusReport status_report(const loop::TickRecord& newest, const loop::TickStats& stats, const store::PublishedField& field);

/// scratch   holds the bins that the report borrows; `kHistogramScratch` bytes are enough
/// returns   the filled classes of one histogram
protocol::HistogramReport histogram_report(protocol::Measure measure, const loop::TickStats& stats, std::span<std::uint8_t> scratch);
inline constexpr std::size_t kHistogramScratch = loop::histogram_layout::kBuckets * protocol::kBinBytes;
static_assert(kHistogramScratch + 64 <= protocol::kMaxBody);

/// scratch   as above
protocol::WorstTicks worst_report(const WorstTicks& worst, std::span<std::uint8_t> scratch);

}  // namespace isotouch::control
