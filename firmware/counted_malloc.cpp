/// Counts the allocations of each thread, so that the tick's can be told to be none. The C library lets a program replace malloc as a whole, and keeps
/// its own under these names; `operator new` ends in malloc too. With an address sanitizer malloc is the sanitizer's, and nothing is counted.
#include <cerrno>
#include <cstddef>

#include "firmware/loop/realtime.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ISOTOUCH_ADDRESS_SANITIZER
#endif
#endif
#if !defined(__SANITIZE_ADDRESS__) && !defined(ISOTOUCH_ADDRESS_SANITIZER)

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the C library's own names
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

void* malloc(std::size_t size) {
  ++isotouch::loop::allocations_of_thread;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  ++isotouch::loop::allocations_of_thread;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  ++isotouch::loop::allocations_of_thread;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  ++isotouch::loop::allocations_of_thread;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  *out = memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}

}  // extern "C"

#endif
