/// The mark of a run: an empty file `running` in the state folder, there while a controller runs. One that a start finds tells that the run before had no
/// orderly end, but a crash, a signal that cannot be heard or a power cut, perhaps with a hand at the grip. Not for the tick.
#pragma once

#include "firmware/store/folder.h"
#include "firmware/store/store_error.h"

namespace isotouch::store {

class RunMark {
 public:
  /// folder    lives longer; other files in it are left alone
  explicit RunMark(Folder& folder);

  /// Was there one at the start?
  bool was_left() const { return left_; }

  /// It survives a power cut from here on.
  ///
  /// fails     kNotAllowed, kNoSpace, kFailed: the next start knows nothing of this run
  StoreResult<void> set();

  /// The end of an orderly run. Where it fails, the next start finds it.
  void clear();

 private:
  Folder& folder_;
  bool left_;
};

}  // namespace isotouch::store
