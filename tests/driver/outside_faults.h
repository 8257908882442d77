/// Faults of what stands around the controller: the host, the disk, the program's end. Part of the fault matrix.
#pragma once

#include <vector>

#include "tests/driver/fault_cases.h"

namespace isotouch::test {

std::vector<FaultRow> outside_faults();

}  // namespace isotouch::test
