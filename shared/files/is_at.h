/// Whether a name still leads to an open file: between `open` and `flock` another program may have taken it away, or put another one in its place.
#pragma once

#include <sys/stat.h>

#include <string>

namespace isotouch::files {

inline bool is_at(int file, const std::string& path) {
  struct stat open {
  }, there{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &there) == 0 && open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

}  // namespace isotouch::files
