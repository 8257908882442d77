/// Replaces malloc and its relatives in the program whose one source includes this, so that each allocation calls
///
///     void isotouch::count_allocation()
///
/// which the program defines; it runs on every thread and must not allocate. `operator new` ends in malloc too. With an address or thread
/// sanitizer malloc is the sanitizer's: nothing is replaced.
///
/// real-time   yes
/// source      the GNU C library's manual, "Replacing malloc": a program may define them, and the library keeps its own under __libc_ names
#pragma once

#include <cerrno>
#include <cstddef>

#include "shared/sanitizers.h"

namespace isotouch {
void count_allocation();
}

#if !ISOTOUCH_ADDRESS_SANITIZER && !ISOTOUCH_THREAD_SANITIZER

// NOLINTBEGIN(misc-definitions-in-headers, bugprone-reserved-identifier, readability-identifier-naming): the C library's own names
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  isotouch::count_allocation();
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  isotouch::count_allocation();
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  isotouch::count_allocation();
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  isotouch::count_allocation();
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  *out = memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}

}  // extern "C"
// NOLINTEND(misc-definitions-in-headers, bugprone-reserved-identifier, readability-identifier-naming)

#endif
