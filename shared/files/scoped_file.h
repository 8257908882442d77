/// An open file that is closed at the end of its scope.
///
/// tick      no: closing may wait
#pragma once

#include <unistd.h>

namespace isotouch {

struct ScopedFile {
  explicit ScopedFile(int open) : number(open) {}
  ~ScopedFile() {
    if (number >= 0) ::close(number);
  }
  ScopedFile(const ScopedFile&) = delete;
  ScopedFile& operator=(const ScopedFile&) = delete;

  int number;  ///< below 0: none is open
};

}  // namespace isotouch
