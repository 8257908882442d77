#include "firmware/store/run_mark.h"

namespace isotouch::store {

namespace {

constexpr const char* kName = "running";

}  // namespace

RunMark::RunMark(Folder& folder) : folder_(folder), left_(static_cast<bool>(folder.size(kName))) {}

StoreResult<void> RunMark::set() {
  StoreResult<void> done = folder_.write(kName, {});
  if (done) done = folder_.sync(kName);
  return done ? folder_.sync_names() : done;
}

void RunMark::clear() {
  if (folder_.remove(kName)) (void)folder_.sync_names();
}

}  // namespace isotouch::store
