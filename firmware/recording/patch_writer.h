/// The patches of a recording, in a file beside it (SPEC.md, section 3.2). Without a patch there is no file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "shared/files/refusal.h"

namespace isotouch::recording {

/// Where the patches of a trace are: its name with the extension `.patches`.
std::string patches_of(const std::string& trace);

/// Writes to "NAME.part", and renames it at the end. Used by one thread.
class PatchWriter {
 public:
  PatchWriter() = default;
  /// As `discard`.
  ~PatchWriter();
  PatchWriter(const PatchWriter&) = delete;
  PatchWriter& operator=(const PatchWriter&) = delete;

  /// trace     the name of the recording
  /// returns   why nothing may be written there: a recording that was cut off has left patches, or what is there may not be replaced
  Refusal begin(const std::string& trace);

  /// returns   why it is not in the file; what was there before stays whole
  Refusal append(std::span<const std::uint8_t> patch);

  /// returns   why there is no file under its name, though there were patches
  Refusal finish();
  /// Leaves nothing behind.
  void discard();

 private:
  std::string part() const { return path_ + ".part"; }

  std::string path_;
  int file_ = -1;
  std::uint64_t bytes_ = 0;  ///< of whole patches
};

}  // namespace isotouch::recording
