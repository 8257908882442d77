#include "shared/files/sync_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "shared/files/scoped_file.h"

namespace isotouch::files {

bool sync_folder_of(const std::string& file) {
  const std::size_t end = file.rfind('/');
  const std::string folder = end == std::string::npos ? "." : file.substr(0, end + 1);
  const ScopedFile open{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (open.number < 0) return errno == EACCES;  // one may write into a folder that one may not read
  return ::fsync(open.number) == 0 || errno == EINVAL;
}

}  // namespace isotouch::files
