/// The mark of a run: a file `running` in the state folder, there while a controller runs. One that a start finds tells that a person must confirm the
/// next force: the run before had no orderly end, but a crash, a signal that cannot be heard or a power cut, perhaps with a hand at the grip; or it left
/// other angles of the device's arms behind. Not for the tick.
#pragma once

#include <cstdint>

#include "firmware/store/folder.h"
#include "shared/files/refusal.h"

namespace isotouch::store {

class RunMark {
 public:
  enum class Left : std::uint8_t {
    kNothing,      ///< an orderly end, or no run before
    kRun,          ///< no orderly end: an empty file
    kCalibration,  ///< a changed calibration, whatever the end: a file that is not empty
  };

  /// folder    lives longer; other files in it are left alone
  explicit RunMark(Folder& folder);

  /// What the run before left behind.
  Left left() const { return left_; }

  /// Marks this run; the mark survives a power cut from here on.
  ///
  /// returns   why there must be no force until a person resumes; none: nothing speaks against it
  Refusal begin();

  /// The angles of the device's arms have changed in this run.
  void note_calibration();

  /// The end of an orderly run. Where it fails, the next start finds the mark.
  void end();

 private:
  bool write(const char* text);

  Folder& folder_;
  Left left_;
  bool calibrated_ = false;
};

}  // namespace isotouch::store
