/// Which device answers, where its arms are taken to stand at count 0, and where that comes from: the geometry set, the settings, or what was measured
/// and kept. Any thread; not for the tick.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "firmware/store/calibration_store.h"
#include "firmware/store/run_mark.h"
#include "shared/device_model.h"
#include "shared/files/refusal.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

class Calibration {
 public:
  struct Choice {
    DeviceModel model;
    protocol::AnglesFrom source = protocol::AnglesFrom::kGeometry;
  };
  /// The model by the settings alone for a serial; kSettings when they name a calibration for it, which then outweighs one that is kept.
  using BySettings = std::function<Choice(const std::string& serial)>;

  /// store     nullptr: nothing is kept; lives longer
  /// mark      is set before other angles are stored; nullptr: nobody could confirm them; lives longer
  /// serial    of the device that is expected; empty: not known
  /// distrust  is called as soon as other angles are kept, also for a device that has gone meanwhile, by the thread that keeps them. answers: theirs is
  ///           the device that answers. Empty: every device is heard with the angles in use, so no others are kept, and none wait
  Calibration(store::CalibrationStore* store, store::RunMark* mark, BySettings by_settings, const std::string& serial,
              std::function<void(bool answers)> distrust = {});

  /// What holds from start to end.
  const Choice& in_use() const { return in_use_; }
  /// Why what was kept cannot be used: then there must be no force until a person resumes.
  const Refusal& trouble() const { return trouble_; }

  /// The device of this serial answers, which may be empty; nullopt: none does.
  void answers(const std::optional<std::string>& serial);

  /// Are there other angles for the device that answers than those in use, or some that cannot be used, so that it is not heard before a new start?
  protocol::OtherAngles others() const;

  protocol::DeviceReport report() const;

  /// Keeps angles for the device that answers, within kFarthestTurnDeg of those of the settings or, where they name none, of the geometry set:
  /// at 10 degrees instead of 35 a force takes four times its motor commands. From then on the next start needs homing and a person's confirmation.
  /// Waits for the disk.
  ///
  /// returns   why they are not kept
  Refusal keep(const protocol::Calibrate& measured);

 private:
  Choice choose(const std::string& serial, Refusal& trouble) const;

  store::CalibrationStore* store_;
  store::RunMark* mark_;
  BySettings by_settings_;
  std::function<void(bool)> distrust_;
  const std::string expected_;  ///< the serial
  Refusal trouble_;
  Choice in_use_;
  mutable std::mutex mutex_;  ///< of what follows
  std::uint64_t keeps_ = 0;   ///< how often angles were kept
  std::string serial_;
  protocol::OtherAngles others_ = protocol::OtherAngles::kNone;
};

}  // namespace isotouch::control
