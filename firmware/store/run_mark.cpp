#include "firmware/store/run_mark.h"

#include <string>

namespace isotouch::store {

namespace {

constexpr const char* kRunning = "running";
constexpr const char* kRecalibrated = "recalibrated";

bool has(Folder& folder, const char* name) { return static_cast<bool>(folder.size(name)); }

}  // namespace

RunMark::RunMark(Folder& folder)
    : folder_(folder),
      crashed_(has(folder, kRunning)),
      recalibrated_(has(folder, kRecalibrated)),
      in_doubt_(crashed_),
      confirms_(recalibrated_) {}

Refusal RunMark::begin() {
  const bool written = write(kRunning);
  if (recalibrated_)
    return "the angles of the device's arms were changed; home it, check its position with 'isotouch watch'; no force until 'resume'";
  if (crashed_) return "the previous run crashed, was killed, lost power or ended before a person had resumed; no force until 'resume'";
  if (!written)
    return "the state folder cannot be written, so the next start could not know whether this run crashed; check its permissions and free "
           "space; no force until 'resume'";
  return {};
}

Refusal RunMark::note_calibration() {
  const std::lock_guard<std::mutex> lock(mutex_);
  confirms_ = false;
  if (write(kRecalibrated)) return {};
  return "the angles were not stored, because the state folder cannot be written and the next start could not ask you to confirm them; "
         "check "
         "its permissions and free space";
}

void RunMark::confirm() {
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  if (!lock) return;
  in_doubt_ = false;
  if (!confirms_) return;
  confirms_ = false;
  if (folder_.remove(kRecalibrated)) (void)folder_.sync_names();
}

void RunMark::end(bool needs_a_person) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (in_doubt_ || needs_a_person) return;
  if (folder_.remove(kRunning)) (void)folder_.sync_names();
}

/// returns   it survives a power cut
bool RunMark::write(const char* name) { return folder_.write(name, {}) && folder_.sync(name) && folder_.sync_names(); }

}  // namespace isotouch::store
