#include "firmware/recording/patch_writer.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "shared/files/part_file.h"
#include "shared/files/sync_folder.h"
#include "shared/files/write_all.h"

namespace isotouch::recording {

namespace {

std::string because(const std::string& path, const char* what, int error) { return path + ": " + what + ": " + std::strerror(error); }

}  // namespace

std::string patches_of(const std::string& trace) {
  const std::size_t name = trace.rfind('/') + 1, dot = trace.rfind('.');  // npos + 1 is 0
  return (dot != std::string::npos && dot > name ? trace.substr(0, dot) : trace) + ".patches";
}

PatchWriter::~PatchWriter() { discard(); }

Refusal PatchWriter::begin(const std::string& trace) {
  discard();
  path_ = patches_of(trace);
  bytes_ = 0;
  if (const Refusal why = files::may_replace(path_))
    return path_ + ": patches of the recording could not be written there: " + why.sentence() + "; name the recording otherwise";
  struct stat there {};
  if (::lstat(part().c_str(), &there) != 0) return {};
  files::OpenPart left = files::open_part(part(), files::Leftover::kRefuse);  // an empty one may stay: whoever writes takes it
  if (left.file >= 0) ::close(left.file);
  if (!left.refusal || left.refusal.sentence().starts_with(part())) return std::move(left.refusal);
  return part() + ": cannot be opened: " + left.refusal.sentence() + "; rename or remove it";
}

Refusal PatchWriter::append(std::span<const std::uint8_t> patch) {
  if (file_ < 0) {
    files::OpenPart opened = files::open_part(part(), files::Leftover::kRefuse);
    if (opened.refusal) return path_ + ": the recording ends at a patch that cannot be written: " + opened.refusal.sentence();
    file_ = opened.file;
  }
  if (file_ >= 0 && files::write_all(file_, patch)) {
    bytes_ += patch.size();
    return {};
  }
  Refusal refusal = because(path_, "the recording ends at a patch that cannot be written", errno);
  if (file_ >= 0) (void)!::ftruncate(file_, static_cast<off_t>(bytes_));
  return refusal;
}

Refusal PatchWriter::finish() {
  if (file_ < 0) return {};
  const bool written = ::fsync(file_) == 0;
  const bool closed = ::close(file_) == 0;
  file_ = -1;
  if (written && closed && std::rename(part().c_str(), path_.c_str()) == 0 && files::sync_folder_of(path_)) return {};
  Refusal refusal = because(path_, "the patches of the recording cannot be written", errno);
  ::unlink(part().c_str());
  return refusal;
}

void PatchWriter::discard() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(part().c_str());
  file_ = -1;
}

}  // namespace isotouch::recording
