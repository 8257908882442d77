#include "firmware/store/run_mark.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "firmware/store/whole_file.h"
#include "shared/fault_names.h"

namespace isotouch::store {

namespace {

constexpr const char* kRunning = "running";
constexpr const char* kRecalibrated = "recalibrated";

bool has(Folder& folder, const char* name) { return static_cast<bool>(folder.size(name)); }

/// By their names, one a line. A mark of an earlier release holds none.
std::uint16_t faults_in_mark(Folder& folder) {
  std::array<std::uint8_t, 256> bytes{};
  const StoreResult<std::size_t> got = folder.read(kRunning, bytes);
  std::string_view lines(reinterpret_cast<const char*>(bytes.data()), got ? *got : 0);
  std::uint16_t faults = 0;
  for (std::size_t end = lines.find('\n'); end != std::string_view::npos; end = lines.find('\n')) {
    for (const FaultName& fault : kFaultNames) {
      if (lines.substr(0, end) == fault.name) faults = static_cast<std::uint16_t>(faults | fault.fault);
    }
    lines.remove_prefix(end + 1);
  }
  return faults;
}

}  // namespace

RunMark::RunMark(Folder& folder)
    : folder_(folder),
      crashed_(has(folder, kRunning)),
      recalibrated_(has(folder, kRecalibrated)),
      faults_(faults_in_mark(folder)),
      in_doubt_(crashed_),
      confirms_(recalibrated_),
      noted_(faults_) {}

Refusal RunMark::begin() {
  const bool written = crashed_ || write(kRunning);  // the mark that is there holds faults
  if (recalibrated_)
    return "the angles of the device's arms were changed; home it, check its position with 'isotouchctl watch'; no force until 'resume'";
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
  if (noted_ != 0) (void)put_faults(0);  // the next time again
  if (!confirms_) return;
  confirms_ = false;
  if (folder_.remove(kRecalibrated)) (void)folder_.sync_names();
}

Refusal RunMark::note(std::uint16_t faults) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto all = static_cast<std::uint16_t>(noted_ | faults);
  const bool told = std::exchange(told_, all != noted_ && !put_faults(all));
  if (!told_ || told) return {};
  std::string text = "the state folder cannot be written, so after a restart nobody will know the fault's name";
  if ((faults & kServiceFaults) != 0) text += ", nor that the role service must resume";
  return text + "; check its permissions and free space";
}

Refusal RunMark::end(std::uint16_t faults) {
  Refusal unnamed = note(faults);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!in_doubt_ && faults == 0 && folder_.remove(kRunning)) (void)folder_.sync_names();
  return unnamed;
}

/// returns   false: the mark stays as it was
bool RunMark::put_faults(std::uint16_t faults) {
  std::string text;
  for (const FaultName& fault : kFaultNames) {
    if ((faults & fault.fault) != 0) text.append(fault.name).append("\n");
  }
  if (!write_whole(folder_, "running.part", kRunning, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()})) {
    return false;
  }
  noted_ = faults;
  return true;
}

/// returns   it survives a power cut
bool RunMark::write(const char* name) { return folder_.write(name, {}) && folder_.sync(name) && folder_.sync_names(); }

}  // namespace isotouch::store
