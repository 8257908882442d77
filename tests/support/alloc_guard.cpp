#include "tests/support/alloc_guard.h"

#include <atomic>
#include <cstddef>

#include "firmware/loop/replaced_malloc.h"

namespace {
std::atomic<std::uint64_t> allocations{0};
}  // namespace

void isotouch::count_allocation() { ++allocations; }

#if ISOTOUCH_ADDRESS_SANITIZER || ISOTOUCH_THREAD_SANITIZER

// The sanitizer owns malloc; it offers a hook instead.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {
[[maybe_unused]] const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { isotouch::count_allocation(); }, [](const volatile void*) {});
}  // namespace

#endif

namespace isotouch::test {

AllocGuard::AllocGuard() : start_(allocations) {}
std::uint64_t AllocGuard::count() const { return allocations - start_; }

}  // namespace isotouch::test
