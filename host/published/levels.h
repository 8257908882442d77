/// Indicator → levels, by peeling.
#pragma once

#include "host/field/progress.h"
#include "host/published/level_field.h"

namespace isotouch::published {

/// Inside nodes with an outside node among their 6 neighbours get level 0 and become outside, the next such layer −1, and so on.
///
/// returns   1 outside; 0, −1, … inside. What is left after level −6 is −7 or deeper and is stored as −7, so the peeling ends there.
///           Beyond the grid is outside
/// fails     never
/// source    Sreeni, 3.2, equation 4: erosion by a unit structuring element
LevelField peel(Indicator inside, field::Progress& progress);

}  // namespace isotouch::published
