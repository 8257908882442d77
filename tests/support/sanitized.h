/// Tests of what memory and arithmetic do need fewer examples than tests of what comes out.
#pragma once

#include <vector>

#include "shared/sanitizers.h"

namespace isotouch::test {

/// Do sanitizers watch this build? They take ten times as long.
inline constexpr bool kSanitized = ISOTOUCH_ADDRESS_SANITIZER != 0 || ISOTOUCH_THREAD_SANITIZER != 0;

/// The examples to try: all of them, or, under sanitizers, the first. Put the most telling one there.
template <class Example>
std::vector<Example> examples(std::vector<Example> all) {
  if (kSanitized) all.erase(all.begin() + 1, all.end());
  return all;
}

}  // namespace isotouch::test
