/// Two marks in the state folder. If a start finds either, a person must confirm the next force. `running` is there while a controller runs. One that a
/// start finds was left by a crash, a signal that cannot be heard or a power cut, perhaps with a hand at the grip; or by a run that ended before a person
/// had done what it waited for. It holds the names of the faults that nobody has resumed after. `recalibrated` is there from before other angles of the
/// device's arms are stored until a person has confirmed them, whatever ends the runs between. Not for the tick.
#pragma once

#include <cstdint>
#include <mutex>

#include "firmware/store/folder.h"
#include "shared/files/refusal.h"

namespace isotouch::store {

class RunMark {
 public:
  /// folder    lives longer; other files in it are left alone
  explicit RunMark(Folder& folder);

  /// The run before had no orderly end, or still waited for a person.
  bool crashed() const { return crashed_; }
  /// The faults that the runs before ended in, and that nobody has confirmed; bits of Faults.
  std::uint16_t faults() const { return faults_; }
  /// At the start of this run nobody had confirmed the angles of the device's arms.
  bool recalibrated() const { return recalibrated_; }

  /// Marks this run; the mark survives a power cut from here on.
  ///
  /// returns   why there must be no force until a person resumes; none: nothing speaks against it
  Refusal begin();

  /// Other angles of the device's arms are about to be stored. Any thread.
  ///
  /// returns   why they must not be
  Refusal note_calibration();

  /// A person has resumed, and the device is homed: the crash before this run is confirmed, and so is what was recalibrated before it. What was in this
  /// run is not. Any thread; does nothing while another one stores angles, so whoever calls it calls it again.
  void confirm();

  /// This run is in faults that the next start must not forget, whatever ends this run. Any thread; waits for the disk where a fault is new.
  ///
  /// faults    bits of Faults; those noted before stay until `confirm`
  /// returns   why their names are not kept, once until they are kept or there are none; the mark stays all the same
  Refusal note(std::uint16_t faults);

  /// The end of an orderly run. The next start finds the mark if that fails, if this run found it and nobody has confirmed it, or as it is asked here.
  ///
  /// faults    that the next start must not forget; 0: none
  /// returns   as `note`
  Refusal end(std::uint16_t faults = 0);

 private:
  bool write(const char* name);
  bool put_faults(std::uint16_t faults);

  Folder& folder_;
  const bool crashed_, recalibrated_;
  const std::uint16_t faults_;  ///< as this run found them
  std::mutex mutex_;            ///< of what follows, and of both marks
  bool in_doubt_;               ///< nobody has confirmed the crash before this run
  bool confirms_;               ///< there are angles to confirm
  std::uint16_t noted_;         ///< the faults in the mark `running`
  bool told_ = false;           ///< that others could not be kept there
};

}  // namespace isotouch::store
