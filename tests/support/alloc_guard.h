/// Counts every allocation of the program, by `new`, `malloc` or any of its relatives, on all threads.
///
///     AllocGuard guard;
///     for (...) tick(...);
///     EXPECT_EQ(guard.count(), 0U);
///
/// A test that uses it also shows once that it counts: a guard that counts nothing proves nothing.
#pragma once

#include <cstdint>

namespace isotouch::test {

class AllocGuard {
 public:
  AllocGuard();
  /// Allocations since construction.
  std::uint64_t count() const;

 private:
  std::uint64_t start_;
};

}  // namespace isotouch::test
