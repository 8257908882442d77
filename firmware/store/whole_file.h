/// A file that a power cut leaves as it was before or as it is meant to be, never in between.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firmware/store/folder.h"

namespace isotouch::store {

/// Writes beside the file's place, syncs, renames, and syncs the folder.
///
/// part      name of the file beside it; of one thread
/// fails     kNotAllowed, kNoSpace, kFailed: the old file is there, or, after kFailed, either
inline StoreResult<void> write_whole(Folder& folder, const std::string& part, const std::string& file,
                                     std::span<const std::uint8_t> bytes) {
  StoreResult<void> done = folder.write(part, bytes);
  if (done) done = folder.sync(part);
  if (done) done = folder.rename(part, file);
  if (done) return folder.sync_names();
  (void)folder.remove(part);
  return done;
}

}  // namespace isotouch::store
