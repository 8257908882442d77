/// Which sanitizers watch this build, by both compilers: each name is 0 or 1. They own malloc, and their own frames take more of a stack.
#pragma once

#if defined(__has_feature)
#define ISOTOUCH_HAS_FEATURE(name) __has_feature(name)
#else
#define ISOTOUCH_HAS_FEATURE(name) 0
#endif

#if defined(__SANITIZE_ADDRESS__) || ISOTOUCH_HAS_FEATURE(address_sanitizer)
#define ISOTOUCH_ADDRESS_SANITIZER 1
#else
#define ISOTOUCH_ADDRESS_SANITIZER 0
#endif

#if defined(__SANITIZE_THREAD__) || ISOTOUCH_HAS_FEATURE(thread_sanitizer)
#define ISOTOUCH_THREAD_SANITIZER 1
#else
#define ISOTOUCH_THREAD_SANITIZER 0
#endif

#undef ISOTOUCH_HAS_FEATURE
