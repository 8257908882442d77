/// What the controller writes: fields, calibrations, marks of a run, recordings, the last ticks.
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "firmware/control/calibration.h"
#include "firmware/recording/last_ticks.h"
#include "firmware/store/field_intake.h"
#include "firmware/store/linux_folder.h"
#include "firmware/store/run_mark.h"
#include "shared/files/trace_file.h"
#include "shared/files/trace_writer.h"
#include "shared/hash64.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/integration/killed_writers.h"

namespace isotouch::test {
namespace {

constexpr std::size_t kImageLimit = 1 << 16, kKept = 4, kBalls = 10;

const store::PackedField& ball(Number number) {
  static const std::vector<store::PackedField> all = [] {
    std::vector<store::PackedField> made;
    for (std::size_t i = 0; i < kBalls; ++i) made.push_back(store::packed_ball(static_cast<int>(i)));
    return made;
  }();
  return all[number % kBalls];
}

/// The tick comes whenever somebody waits for it.
class TickingClock final : public loop::Clock {
 public:
  explicit TickingClock(loop::FieldSlots& slots) : slots_(slots) {}
  std::int64_t now_ns() override { return now_; }
  void sleep_until_ns(std::int64_t when_ns) override {
    now_ = std::max(now_, when_ns);
    static_cast<void>(slots_.field());
  }

 private:
  loop::FieldSlots& slots_;
  std::int64_t now_ = 0;
};

/// An intake on a folder, as a controller begins with it.
struct Intake {
  explicit Intake(const fs::path& path)
      : folder(path.string()), store(folder, kKept), slots(kImageLimit), clock(slots), intake(slots, &store, clock, {}) {}

  store::LinuxFolder folder;
  store::FieldStore store;
  loop::FieldSlots slots;
  TickingClock clock;
  store::FieldIntake intake;
};

class Uploads final : public Kind {
 public:
  using Kind::Kind;
  void write(Number first, const Reporter& report) override {
    Intake here(folder());
    for (Number number = first;; ++number) {
      const store::PackedField& field = ball(number);
      std::copy(field.bytes.begin(), field.bytes.end(), here.intake.upload().begin());
      report.begin(number);
      if (!here.intake.accept(field.promise).refusal) report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    Intake here(folder());
    if (const Refusal refusal = here.intake.begin_with_active())
      wrong = "the next start does not find the active field: " + refusal.sentence();
    for (const store::StoredField& field : here.intake.stored()) {
      Intake other(folder() / ".." / "other");
      std::vector<std::uint8_t> bytes(here.intake.upload().size());
      const auto got = here.store.read(field.hash, bytes);
      if (!got) wrong = "the stored field " + field.file + " cannot be read";
      if (got && other.intake.begin_with(std::span(bytes).first(*got), "")) wrong = "the stored field " + field.file + " is not whole";
    }
    // Each kill between a new field and the end of the oldest one leaves one more; the next upload that ends drops them all.
    if (here.intake.stored().size() > kKept + 4) wrong = "more fields are kept than may be";
    const std::uint64_t hash = here.intake.published().image_hash;
    for (Number i = 0; hash != 0 && i < kBalls; ++i)
      if (ball(i).promise.image_hash == hash) return i + kBalls;  // modulo kBalls
    return 0;
  }
};

std::array<std::uint32_t, 3> angles_of(Number number) {
  std::array<std::uint32_t, 3> angles{};
  const DeviceModel model = libnifalcon_model();
  for (std::size_t i = 0; i < 3; ++i)
    angles[i] = static_cast<std::uint32_t>(model.legs[i].at_zero.raw()) + static_cast<std::uint32_t>(number);
  return angles;
}

class Calibrations final : public Kind {
 public:
  using Kind::Kind;
  void write(Number first, const Reporter& report) override {
    store::LinuxFolder folder_now(folder().string());
    store::CalibrationStore store(folder_now);
    store::RunMark mark(folder_now);
    control::Calibration calibration(
        &store, &mark, [](const std::string&) { return control::Calibration::Choice{libnifalcon_model()}; }, "A1", [](bool) {});
    calibration.answers("A1");
    for (Number number = first;; ++number) {
      protocol::Calibrate measured{protocol::Text::of("A1"), angles_of(number)};
      report.begin(number);
      if (!calibration.keep(measured)) report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    store::LinuxFolder folder_now(folder().string());
    const auto kept = store::CalibrationStore(folder_now).read("A1");
    if (!kept && kept.error() == store::StoreError::kNotFound) return 0;
    if (!kept) {
      wrong = std::string("the calibration cannot be read: ") + store::describe(kept.error());
      return 0;
    }
    if (!store::RunMark(folder_now).recalibrated()) wrong = "other angles are stored, and nobody is asked to confirm them";
    const Number number = static_cast<std::uint32_t>((*kept)[0].raw()) - angles_of(0)[0];
    for (std::size_t i = 0; i < 3; ++i)
      if (static_cast<std::uint32_t>((*kept)[i].raw()) != angles_of(number)[i]) wrong = "the angles are of two calibrations";
    return number;
  }
};

/// Odd writes are begins of a run, even ones its ends.
class RunMarks final : public Kind {
 public:
  using Kind::Kind;
  void write(Number first, const Reporter& report) override {
    store::LinuxFolder folder_now(folder().string());
    for (Number number = first | 1;; number += 2) {
      store::RunMark mark(folder_now);
      report.begin(number);
      static_cast<void>(mark.begin());
      report.done(number);
      mark.confirm();  // a run that begins after a kill ends in doubt otherwise
      report.begin(number + 1);
      static_cast<void>(mark.end());
      report.done(number + 1);
    }
  }
  Number found(Verdict&) override {
    store::LinuxFolder folder_now(folder().string());
    return store::RunMark(folder_now).crashed() ? 1 : 2;  // modulo 2
  }
};

TraceHeader header_of(Number number) {
  TraceHeader header;
  header.field_hash = number;
  return header;
}

TraceRecord record_of(Number number, std::uint64_t tick) {
  TraceRecord record;
  record.input = position_input({Mm::from_raw(static_cast<std::int32_t>(number)), Mm::from_raw(static_cast<std::int32_t>(tick)), {}});
  return record;
}

class Recordings final : public Kind {
 public:
  using Kind::Kind;
  std::string path() const { return (folder() / "a.trace").string(); }
  static std::uint64_t ticks_of(Number number) { return 100 + number % 700; }

  void write(Number first, const Reporter& report) override {
    for (Number number = first;; ++number) {
      files::TraceWriter writer;
      report.begin(number);
      if (writer.begin(path(), header_of(number))) return;
      for (std::uint64_t tick = 0; tick < ticks_of(number); ++tick) static_cast<void>(writer.append(record_of(number, tick)));
      if (!writer.finish(files::Keep::kWhatFits)) report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    files::TraceFile part;
    if (fs::exists(path() + ".part") && fs::file_size(path() + ".part") >= trace_layout::kHeaderBytes + trace_layout::kRecordBytes) {
      if (const Refusal refusal = files::read_trace(path() + ".part", part))
        wrong = "an unfinished recording cannot be read: " + refusal.sentence();
      check_ticks(part, wrong);
    }
    if (!fs::exists(path())) return 0;
    files::TraceFile trace;
    if (const Refusal refusal = files::read_trace(path(), trace)) {
      wrong = "a recording cannot be read: " + refusal.sentence();
      return 0;
    }
    const Number number = trace.header().field_hash;
    if (!trace.cut_off().empty() || trace.size() != ticks_of(number)) wrong = "a recording under its name is not whole";
    check_ticks(trace, wrong);
    return number;
  }

 private:
  static void check_ticks(const files::TraceFile& trace, Verdict& wrong) {
    for (std::size_t tick = 0; tick < trace.size(); ++tick)
      if (trace.record(tick).input != record_of(trace.header().field_hash, tick).input) wrong = "a recording has ticks of another one";
  }
};

/// Each write is a tick.
class LastTickFiles final : public Kind {
 public:
  using Kind::Kind;
  std::string path() const { return (folder() / "last").string(); }
  bool begins_anew() const override { return true; }

  void write(Number first, const Reporter& report) override {
    recording::LastTicks last;
    if (last.begin(path(), header_of(1), 500)) return;
    for (Number number = first;; ++number) {
      recording::LastTick tick;
      tick.tick.number = number;
      tick.tick.in = record_of(1, number).input;
      report.begin(number);
      last.put(tick);
      report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    TraceHeader header;
    const auto ticks = recording::LastTicks::read(path(), header);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      if (ticks[i].tick.number != ticks[0].tick.number + i) wrong = "the last ticks have a gap";
      if (ticks[i].tick.in != record_of(1, ticks[i].tick.number).input) wrong = "a last tick is mixed of two";
    }
    return ticks.empty() ? 0 : ticks.back().tick.number;
  }
};

}  // namespace

std::vector<NamedKind> controller_writers() {
  return {named<Uploads>("uploads", kBalls), named<Calibrations>("calibrations"), named<RunMarks>("run-marks", 2),
          named<Recordings>("recordings"), named<LastTickFiles>("last-ticks")};
}

}  // namespace isotouch::test
