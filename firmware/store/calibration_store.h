/// Where the arms of a device stand at count 0, kept for each serial: files in one folder.
///
///   calibration-SERIAL     three angles (`Angle`), legs 1 to 3, and the checksum of them: four numbers of 8 hexadecimal digits, a blank between, a line's end
///
/// Each file is written whole (`whole_file.h`). Not for the tick.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "firmware/store/folder.h"
#include "firmware/store/store_error.h"
#include "shared/angle.h"

namespace isotouch::store {

using AnglesAtZero = std::array<Angle, 3>;

class CalibrationStore {
 public:
  /// folder    lives longer; other files in it are left alone
  explicit CalibrationStore(Folder& folder) : folder_(folder) {}

  /// fails     kNotFound; kDamaged: the file is not as above; as Folder::read
  StoreResult<AnglesAtZero> read(const std::string& serial) const;

  /// It survives a power cut from here on.
  ///
  /// serial    letters and digits, at least one
  /// fails     kNotAllowed, kNoSpace, kFailed: the one before is there, or, after kFailed, either
  StoreResult<void> put(const std::string& serial, const AnglesAtZero& angles);

  /// Is it one that a file can be named after?
  static bool is_serial(const std::string& serial);

 private:
  Folder& folder_;
};

}  // namespace isotouch::store
