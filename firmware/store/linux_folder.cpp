#include "firmware/store/linux_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "shared/files/scoped_file.h"
#include "shared/files/write_all.h"

namespace isotouch::store {

namespace {

StoreError error_of(int code) {
  switch (code) {
    case ENOENT: return StoreError::kNotFound;
    case EACCES:
    case EPERM:
    case EROFS: return StoreError::kNotAllowed;
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return StoreError::kNoSpace;
    case EWOULDBLOCK: return StoreError::kInUse;
    default: return StoreError::kFailed;
  }
}

StoreResult<void> done_if(bool done) {
  if (!done) return error_of(errno);
  return {};
}

}  // namespace

LinuxFolder::LinuxFolder(const std::string& path) {
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) trouble_ = error_of(errno);
  folder_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_ >= 0 && ::flock(folder_, LOCK_EX | LOCK_NB) == 0) return;
  trouble_ = error_of(errno);
  if (folder_ >= 0) ::close(std::exchange(folder_, -1));
}

LinuxFolder::~LinuxFolder() {
  if (folder_ >= 0) ::close(folder_);
}

std::vector<std::string> LinuxFolder::names() {
  std::vector<std::string> names;
  const int again = ::openat(folder_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* list = again < 0 ? nullptr : ::fdopendir(again);
  if (list == nullptr) {
    if (again >= 0) ::close(again);
    return names;
  }
  for (const dirent* entry = ::readdir(list); entry != nullptr; entry = ::readdir(list)) {
    struct stat about {};
    if (::fstatat(folder_, entry->d_name, &about, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(about.st_mode)) names.emplace_back(entry->d_name);
  }
  ::closedir(list);
  return names;
}

StoreResult<std::uint64_t> LinuxFolder::size(const std::string& name) {
  struct stat about {};
  if (::fstatat(folder_, name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0) return error_of(errno);
  return static_cast<std::uint64_t>(about.st_size);
}

StoreResult<std::size_t> LinuxFolder::read(const std::string& name, std::span<std::uint8_t> out) {
  const StoreResult<std::uint64_t> bytes = size(name);
  if (!bytes) return bytes.error();
  if (*bytes > out.size()) return StoreError::kTooLarge;
  const ScopedFile file{::openat(folder_, name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)};
  if (file.number < 0) return error_of(errno);
  std::size_t got = 0;
  while (got < out.size()) {
    const ssize_t more = ::read(file.number, out.data() + got, out.size() - got);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return StoreError::kFailed;
    if (more == 0) break;
    got += static_cast<std::size_t>(more);
  }
  return got;
}

StoreResult<void> LinuxFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) {
  const ScopedFile file{::openat(folder_, name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600)};
  if (file.number < 0) return error_of(errno);
  if (!files::write_all(file.number, bytes)) return error_of(errno);
  return {};
}

StoreResult<void> LinuxFolder::sync(const std::string& name) {
  const ScopedFile file{::openat(folder_, name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)};
  return done_if(file.number >= 0 && ::fsync(file.number) == 0);
}

StoreResult<void> LinuxFolder::rename(const std::string& from, const std::string& to) {
  return done_if(::renameat(folder_, from.c_str(), folder_, to.c_str()) == 0);
}

StoreResult<void> LinuxFolder::remove(const std::string& name) { return done_if(::unlinkat(folder_, name.c_str(), 0) == 0); }

StoreResult<void> LinuxFolder::sync_names() { return done_if(::fsync(folder_) == 0); }

}  // namespace isotouch::store
