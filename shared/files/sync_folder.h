/// After a rename: the new name survives a power cut.
///
/// tick      no: it waits for the disk
#pragma once

#include <string>

namespace isotouch::files {

/// Syncs the folder that a file is in. Where the file system cannot sync folders, or this user may write into the folder but not read it, there is
/// nothing that could be done, and the answer is true.
///
/// file      its path
/// returns   false: the folder cannot be opened or the disk failed; errno says why
bool sync_folder_of(const std::string& file);

}  // namespace isotouch::files
