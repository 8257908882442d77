/// What `isotouch stream` tells people and programs: a line each second, and the whole at its end.
#pragma once

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "host/stream/stream.h"

namespace isotouch::commands {

/// On standard error, for whoever watches.
///
/// now       seconds since the stream began
/// thinned   frames that were left out
/// lost      ticks of the hand
/// silent    the controller whose hand did not tick meanwhile; empty: none
/// of        what the second brought
/// fault     in which the controller is; empty: none
void print_second(double now, std::uint64_t thinned, std::uint64_t lost, const std::string& silent, const stream::Tally& of,
                  const std::string& fault);

/// docs/json/stream.json. Here and below: of a stream that has a field.
nlohmann::ordered_json summary_json(const stream::Stream& of, const std::string& field_hash);

/// is_sent   there is a controller that the field goes to
void print_summary(const stream::Stream& of, const std::string& field_hash, bool is_sent, std::FILE* to);

}  // namespace isotouch::commands
