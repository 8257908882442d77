/// Where an output goes: the file that its name stands for, and the part beside it that is written first.
///
/// tick      no: it waits for the disk
#pragma once

#include <string>

#include "shared/files/refusal.h"

namespace isotouch::files {

/// What a name for an output leads to.
struct OutputPlace {
  std::string path;     ///< behind all symbolic links; a file there, if there is one, is to be replaced
  int descriptor = -1;  ///< at least 0: the path is that of an open file of this process, such as /dev/stdout, and cannot be replaced
};

/// Follows symbolic links, also to where no file is yet. A chain of more than 40 links is followed as far as that.
OutputPlace output_place(const std::string& name);

/// What to do with a part that is left of a program which was killed.
enum class Leftover {
  kReplace,  ///< it can be made again, unless it is that of a controller's recording, which is refused all the same
  kRefuse,   ///< it holds what nobody can make again
};

/// May a part take the place of what is there? Where nothing is, it may.
///
/// output    its path, behind all symbolic links
/// returns   why not, without the path
Refusal may_replace(const std::string& output);

struct OpenPart {
  int file = -1;    ///< empty, for reading and writing; below 0: none is open
  Refusal refusal;  ///< why
};

/// Opens a part, which nobody else can open so until it is closed. What is renamed while it is open stays locked. Where there is a file NAME, the part gets
/// its owner, group, permissions and access control list. What this process may not pass on makes the part less accessible, never more. None is opened if
/// `may_replace` refuses it.
///
/// part      its path, "NAME.part" for an output NAME
OpenPart open_part(const std::string& part, Leftover leftover);

}  // namespace isotouch::files
