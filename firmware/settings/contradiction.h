/// Settings that are fine one by one and not together: the file would promise a protection that nobody gives.
#pragma once

#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"

namespace isotouch::settings {

/// returns   the first contradiction, with what to do; none: the settings may hold together
Refusal refusal_of_contradiction(const Settings& settings);

}  // namespace isotouch::settings
