/// Tests of what memory and arithmetic do need fewer examples than tests of what comes out.
#pragma once

#include <vector>

namespace isotouch::test {

/// Do sanitizers watch this build? They take ten times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

/// The examples to try: all of them, or, under sanitizers, the first. Put the most telling one there.
template <class Example>
std::vector<Example> examples(std::vector<Example> all) {
  if (kSanitized) all.erase(all.begin() + 1, all.end());
  return all;
}

}  // namespace isotouch::test
