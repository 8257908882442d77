#include "shared/files/part_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "shared/files/c_deleter.h"
#include "shared/trace.h"

namespace isotouch::files {

namespace {

constexpr int kMostLinks = 40;  // as many as the kernel follows
constexpr mode_t kPermissions = 0777;
constexpr const char* kAccessList = "system.posix_acl_access";

/// The number of the open file of this process that a path under /proc names; -1: it names none.
int descriptor_at(const std::string& path) {
  const std::size_t name = path.rfind('/') + 1;  // npos + 1 is 0
  const std::unique_ptr<char, CDeleter<std::free>> folder(::realpath(name == 0 ? "." : path.substr(0, name).c_str(), nullptr));
  if (!folder || folder.get() != "/proc/" + std::to_string(::getpid()) + "/fd") return -1;
  char* end = nullptr;
  const long number = std::strtol(path.c_str() + name, &end, 10);
  return *end == '\0' && end != path.c_str() + name && number >= 0 && number <= INT_MAX ? static_cast<int>(number) : -1;
}

/// Does a name still lead to an open file? Between `open` and `flock` another program may have taken it away, or put another one in its place.
bool is_at(int file, const std::string& path) {
  struct stat open {
  }, there{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &there) == 0 && open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

/// Is it the part of a controller's recording, as far as its writer came? A replay of one looks the same, so it is kept, too.
bool is_recording(int file, off_t size) {
  TraceHeaderBytes bytes{};
  if (size <= static_cast<off_t>(bytes.size()) || ::pread(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return false;
  const Result<TraceHeader> header = decode_header(bytes);
  return header && header->record_count == kUnfinished && header->has_outputs && header->settings_checksum != 0;
}

/// The access control list of a file, as the kernel keeps it; empty: there is none.
std::vector<char> access_list(const std::string& path) {
  std::vector<char> list(XATTR_SIZE_MAX);
  const ssize_t size = ::getxattr(path.c_str(), kAccessList, list.data(), list.size());
  list.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return list;
}

/// Gives a part the access rights of the file that it is to replace. What this process may not pass on it takes away: nobody but the owner gets more.
///
/// returns   false: errno says why the part cannot have as few rights as the file
bool protect_as(int part, const std::string& output, const struct stat& before) {
  struct stat there {};
  if (::fstat(part, &there) != 0) return false;
  const std::vector<char> list = access_list(output);
  if (::fremovexattr(part, kAccessList) != 0 && errno != ENODATA && errno != EOPNOTSUPP) return false;  // that of the folder
  const bool same_group = there.st_gid == before.st_gid || ::fchown(part, static_cast<uid_t>(-1), before.st_gid) == 0;
  const bool same_list = list.empty() || (same_group && ::fsetxattr(part, kAccessList, list.data(), list.size(), 0) == 0);
  mode_t mode = before.st_mode & kPermissions;
  if (!same_group) {  // who was in the group is one of the others now, and the other way round
    const mode_t all = mode >> 3 & mode & 07;
    mode = (mode & 0700) | all << 3 | all;
  }
  if (!same_list) mode &= 0700;  // bits cannot say whom the list lets in
  if ((::fstat(part, &there) != 0 || (there.st_mode & kPermissions) != mode) && ::fchmod(part, mode) != 0) return false;
  if (there.st_uid != before.st_uid) (void)!::fchown(part, before.st_uid, static_cast<gid_t>(-1));  // last: only an owner may do the rest
  return true;
}

}  // namespace

OutputPlace output_place(const std::string& name) {
  OutputPlace place{name};
  for (int links = 0; links < kMostLinks; ++links) {
    if ((place.descriptor = descriptor_at(place.path)) >= 0) return place;
    std::array<char, PATH_MAX> target{};
    const ssize_t size = ::readlink(place.path.c_str(), target.data(), target.size());
    if (size <= 0) return place;
    const std::string to(target.data(), static_cast<std::size_t>(size));
    place.path = to.front() == '/' ? to : place.path.substr(0, place.path.rfind('/') + 1) + to;
  }
  return place;
}

Refusal may_replace(const std::string& output) {
  struct stat there {};
  if (::stat(output.c_str(), &there) != 0) return {};
  if (!S_ISREG(there.st_mode)) return "it is a folder, a device or a pipe";
  if (::faccessat(AT_FDCWD, output.c_str(), W_OK, AT_EACCESS) != 0) return std::strerror(errno);
  return {};
}

OpenPart open_part(const std::string& part, Leftover leftover) {
  const auto refused = [&](const std::string& what) { return OpenPart{-1, part + ": " + what}; };
  const std::string output = part.substr(0, part.rfind('.'));
  struct stat before {};
  const bool is_there = ::stat(output.c_str(), &before) == 0;
  if (Refusal why = may_replace(output)) return {-1, std::move(why)};
  const mode_t mode = is_there ? 0600 : 0666;  // nobody else opens it before it has the rights of the file there
  constexpr int kTries = 100;                  // a file system may give one file several numbers
  for (int tries = 1;; ++tries) {
    const int file = ::open(part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, mode);
    if (file < 0 && errno == ELOOP) return refused("is a symbolic link, which may lead anywhere; remove it");
    if (file < 0) return {-1, std::strerror(errno)};
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;  // a file system without locks has none to respect
    if (locked && tries < kTries && !is_at(file, part)) {  // another program has just finished it: it has another name now
      ::close(file);
      continue;
    }
    struct stat there {};
    const bool regular = ::fstat(file, &there) == 0 && S_ISREG(there.st_mode);
    const bool is_kept = locked && regular && there.st_size > 0 && (leftover == Leftover::kRefuse || is_recording(file, there.st_size));
    const auto is_protected = [&] { return !is_there || protect_as(file, output, before); };
    if (locked && regular && !is_kept && (there.st_size == 0 || ::ftruncate(file, 0) == 0) && is_protected()) return {file, {}};
    const int why = errno;
    ::close(file);
    if (!regular) return refused("is no file; remove it");
    if (!locked) return refused("another program is writing there; wait for its end, or choose another name");
    if (!is_kept) return {-1, std::strerror(why)};
    return refused("is left of a recording that was cut off; rename it to keep it, or remove it");
  }
}

}  // namespace isotouch::files
