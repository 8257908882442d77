#include "firmware/store/run_mark.h"

#include <cstring>
#include <string>

namespace isotouch::store {

namespace {

constexpr const char* kName = "running";

RunMark::Left left_in(Folder& folder) {
  const StoreResult<std::uint64_t> bytes = folder.size(kName);
  if (!bytes) return RunMark::Left::kNothing;
  return *bytes == 0 ? RunMark::Left::kRun : RunMark::Left::kCalibration;
}

}  // namespace

RunMark::RunMark(Folder& folder) : folder_(folder), left_(left_in(folder)) {}

Refusal RunMark::begin() {
  const bool written = write("");
  if (left_ == Left::kCalibration)
    return "the angles of the device's arms were changed; home it, check its position with 'isotouch watch'; no force until 'resume'";
  if (left_ == Left::kRun) return "the previous run crashed, was killed or lost power; no force until 'resume'";
  if (!written) return "the state folder cannot be written, so the next start will not know if this run crashed; no force until 'resume'";
  return {};
}

void RunMark::note_calibration() {
  if (!calibrated_) calibrated_ = write("calibrated\n");
}

void RunMark::end() {
  if (!calibrated_ && folder_.remove(kName)) (void)folder_.sync_names();
}

/// returns   it survives a power cut
bool RunMark::write(const char* text) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text);
  return folder_.write(kName, {bytes, std::strlen(text)}) && folder_.sync(kName) && folder_.sync_names();
}

}  // namespace isotouch::store
