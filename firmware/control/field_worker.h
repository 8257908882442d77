/// The thread in which uploads are unpacked, patches applied, checked and stored, images copied, and calibrations kept, so that nobody who wants to stop the device waits for a disk.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/store/field_intake.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

struct FieldWork {
  enum class Kind : std::uint8_t { kAccept, kPatch, kSelect, kList, kCopy, kCalibrate };
  Kind kind{};
  protocol::Begin field;         ///< kPatch: its bytes alone; kSelect: its hash alone
  protocol::Calibrate measured;  ///< kCalibrate
  std::uint32_t user = 0;        ///< who wants it
};

struct FieldDone {
  FieldWork::Kind kind{};
  std::uint32_t user = 0;
  store::IntakeOutcome outcome;            ///< of kAccept, kPatch, kSelect and kCopy; of kCalibrate its refusal alone
  std::vector<store::StoredField> stored;  ///< of kList
};

/// One piece of work at a time. Between `begin` and a `take` that returns something the intake belongs to the thread.
class FieldWorker {
 public:
  /// intake, calibration   live longer; without a calibration there is no work kCalibrate
  FieldWorker(store::FieldIntake& intake, Calibration* calibration);
  /// Ends what is under way and joins the thread.
  ~FieldWorker();
  FieldWorker(const FieldWorker&) = delete;
  FieldWorker& operator=(const FieldWorker&) = delete;

  bool is_idle() const { return !under_way_; }
  bool keeps_angles() const { return under_way_ == FieldWork::Kind::kCalibrate; }
  /// Only when idle.
  void begin(const FieldWork& work);
  /// What has become of it, once; idle again from here on.
  std::optional<FieldDone> take();
  /// Readable when there is something to take; for poll.
  int bell() const { return bell_; }

 private:
  void run();
  FieldDone work(const FieldWork& wanted);

  store::FieldIntake& intake_;
  Calibration* calibration_;
  int bell_;
  std::optional<FieldWork::Kind> under_way_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<FieldWork> wanted_;
  std::optional<FieldDone> done_;
  bool stop_ = false;
  std::thread thread_;  // last: everything above is there when it begins
};

}  // namespace isotouch::control
