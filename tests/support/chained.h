/// Records that a test made or moved, as a recording holds them.
#pragma once

#include "shared/trace.h"

namespace isotouch::test {

/// The record with the chain that follows.
///
/// chain     of the records before it, begun with their header; goes on by this one
inline TraceRecord chained(Chain& chain, TraceRecord record) {
  record.chain = chain.extend(record.input, record.output);
  return record;
}

}  // namespace isotouch::test
