#include "firmware/control/calibration.h"

#include <cstdint>
#include <utility>

namespace isotouch::control {

using protocol::OtherAngles;

namespace {

void take(const store::AnglesAtZero& angles, DeviceModel& model) {
  for (std::size_t i = 0; i < angles.size(); ++i) model.legs[i].at_zero = angles[i];
}

std::string too_far() {
  return "an arm would stand more than " + std::to_string(kFarthestTurnDeg) +
         " degrees away from where the device's geometry has it; measure again, or try the other [device] geometry";
}

/// Does every arm stand near enough to where it is expected?
bool is_near(const store::AnglesAtZero& angles, const DeviceModel& expected) {
  bool near = true;
  for (std::size_t i = 0; i < angles.size(); ++i) near = near && stands_near(angles[i], expected.legs[i].at_zero);
  return near;
}

}  // namespace

Calibration::Calibration(store::CalibrationStore* store, store::RunMark* mark, BySettings by_settings, const std::string& serial,
                         std::function<void(bool)> distrust)
    : store_(store),
      mark_(mark),
      by_settings_(std::move(by_settings)),
      distrust_(std::move(distrust)),
      expected_(serial),
      in_use_(choose(serial, trouble_)) {}

void Calibration::answers(const std::optional<std::string>& serial) {
  bool has_others = false;
  std::uint64_t keeps = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  do {
    keeps = keeps_;
    lock.unlock();
    if (serial && distrust_) {
      Refusal trouble;
      has_others = choose(*serial, trouble).model != in_use_.model || (trouble && *serial != expected_);  // that a person must hear of
    }
    lock.lock();
  } while (keeps != keeps_);  // what was read may be what was kept before
  serial_ = serial.value_or("");
  others_ = has_others ? OtherAngles::kUntrusted : OtherAngles::kNone;
}

OtherAngles Calibration::others() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return others_;
}

protocol::DeviceReport Calibration::report() const {
  protocol::DeviceReport report;
  for (std::size_t i = 0; i < report.at_zero.size(); ++i) report.at_zero[i] = in_use_.model.legs[i].at_zero.raw();
  report.from = static_cast<std::uint8_t>(in_use_.source);
  const std::lock_guard<std::mutex> lock(mutex_);
  report.waits = static_cast<std::uint8_t>(others_);
  report.serial = protocol::Text::of(serial_);
  return report;
}

Refusal Calibration::keep(const protocol::Calibrate& measured) {
  const std::string serial(measured.serial.view());
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (serial_.empty() || serial != serial_) return "another device than the measured one is plugged in; calibrate again";
  }
  if (!distrust_) return "a controller in lockstep keeps the angles that it began with; start it without --lockstep";
  if (store_ == nullptr) return "this controller has no state folder to store it in; set [files] state and start it again";
  const Choice expected = by_settings_(serial);
  if (expected.source == protocol::AnglesFrom::kSettings) {
    return "the controller's settings have a calibration for this device, which is used instead of a measured one; remove [calibration." +
           serial + "] from the settings";
  }
  store::AnglesAtZero angles;
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = Angle::from_raw(measured.at_zero[i]);
  if (!is_near(angles, expected.model)) return too_far();
  if (Refusal refusal = mark_ != nullptr ? mark_->note_calibration() : Refusal()) return refusal;
  const store::StoreResult<void> kept = store_->put(serial, angles);
  if (!kept) return std::string("the calibration cannot be stored: ") + describe(kept.error()) + "; check the controller's state folder";
  Refusal ignored;
  const bool has_others = choose(serial, ignored).model != in_use_.model;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++keeps_;
  const bool answers = serial == serial_;  // another device may do so by now, or none
  if (answers && !has_others) others_ = OtherAngles::kNone;
  if (answers && has_others && others_ == OtherAngles::kNone) others_ = OtherAngles::kKept;
  if (has_others) distrust_(answers);  // also if it does not answer now: it is the expected one when it comes back
  return {};
}

Calibration::Choice Calibration::choose(const std::string& serial, Refusal& trouble) const {
  Choice choice = by_settings_(serial);
  if (store_ == nullptr || choice.source == protocol::AnglesFrom::kSettings) return choice;
  const store::StoreResult<store::AnglesAtZero> kept = store_->read(serial);
  if (kept && !is_near(*kept, choice.model)) {
    trouble = "the stored calibration of " + serial + " is not used: " + too_far();
  } else if (kept) {
    take(*kept, choice.model);
    choice.source = protocol::AnglesFrom::kMeasured;
  } else if (kept.error() != store::StoreError::kNotFound) {
    trouble = "the stored calibration of " + serial + " cannot be used: " + describe(kept.error()) + "; calibrate again";
  }
  return choice;
}

}  // namespace isotouch::control
