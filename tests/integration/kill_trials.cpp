/// Kills a writer at a random moment, again and again, and looks at what it leaves: kill_trials FOLDER KILLS [SEED [KIND...]]
///
/// A child writes one thing after the other and says on a pipe what it begins and what has been acknowledged. The parent kills it, opens what is there with
/// fresh objects, and checks: nothing acknowledged is lost, nothing is half-written, the next start is clean, and the folder does not grow. A kind
/// fails, too, if hardly any kill fell into a write.
///
/// A kill loses nothing that was handed to the kernel. What a power cut loses is tried in tests/firmware/store.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/recording/last_ticks.h"
#include "firmware/store/field_intake.h"
#include "firmware/store/linux_folder.h"
#include "firmware/store/run_mark.h"
#include "host/error.h"
#include "host/farm/answer.h"
#include "host/files/whole_file.h"
#include "shared/files/trace_file.h"
#include "shared/files/trace_writer.h"
#include "shared/hash64.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch {
namespace {

namespace fs = std::filesystem;
using Number = std::uint64_t;  // of a write, from 1; 0 = none

/// What the child said before it was killed.
struct Heard {
  Number begun = 0, done = 0;
};

/// Says on the pipe what a child begins and what is acknowledged.
class Reporter {
 public:
  explicit Reporter(int pipe) : pipe_(pipe) {}
  void begin(Number number) const { say(number << 1); }
  void done(Number number) const { say(number << 1 | 1); }

 private:
  void say(Number word) const { (void)!::write(pipe_, &word, sizeof word); }
  int pipe_;
};

/// Why a trial fails, as one clause; empty: all holds.
using Verdict = std::string;

/// One kind of write.
class Kind {
 public:
  explicit Kind(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }
  virtual ~Kind() = default;
  /// In the child: writes number `first` and those behind it, for ever.
  virtual void write(Number first, const Reporter& report) = 0;
  /// In the parent: which write is there? It must be whole. 0: none.
  virtual Number found(Verdict& wrong) = 0;
  /// A writer begins with nothing, because a controller has saved before what the run before it left.
  virtual bool begins_anew() const { return false; }

  const fs::path& folder() const { return folder_; }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

 private:
  fs::path folder_;
};

// ---- what the controller writes --------------------------------------------------------------------------------------------------------------

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
        &store, &mark, [](const std::string&) { return control::Calibration::Choice{libnifalcon_model()}; }, "A1");
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
      ::usleep(200);  // it runs
      report.begin(number + 1);
      mark.end();
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

// ---- what the host tool writes ---------------------------------------------------------------------------------------------------------------

/// Bytes that say which write they are of, and are long enough for several pages.
std::vector<std::uint8_t> bytes_of(Number number) {
  std::vector<std::uint8_t> bytes(20'000 + number % 100 * 1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>((number >> i % 8 * 8) & 0xFF);
  return bytes;
}

class ToolFiles final : public Kind {
 public:
  using Kind::Kind;
  fs::path path() const { return folder() / "out.itf"; }
  void write(Number first, const Reporter& report) override {
    for (Number number = first;; ++number) {
      const auto bytes = bytes_of(number);
      report.begin(number);
      write_file(path(), bytes.data(), bytes.size());
      report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    if (!fs::exists(path())) return 0;
    const auto bytes = read_file(path());
    Number number = 0;
    for (std::size_t i = 0; i < 8 && i < bytes.size(); ++i) number |= Number{bytes[i]} << 8 * i;
    if (bytes != bytes_of(number)) wrong = "a file of the tool is not whole";
    return number;
  }
};

class Answers final : public Kind {
 public:
  using Kind::Kind;
  void write(Number first, const Reporter& report) override {
    for (Number number = first;; ++number) {
      farm::Answer answer{farm::Answer::Outcome::kEqual, number, 1, "0123456789abcdef", {}, {}};
      report.begin(number);
      farm::keep(folder(), recording_, program_, answer);
      report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    const std::string address = farm::address_of(recording_, program_);
    const fs::path file = folder() / address.substr(0, 2) / (address.substr(2) + ".json");
    const auto answer = farm::kept_answer(folder(), address);
    if (!answer && fs::exists(file)) wrong = "a kept answer is none";
    return answer ? answer->ticks : 0;
  }

 private:
  farm::Recording recording_{"a", "a.itf", "a.trace", "0", "0", "0", "device", "origin"};
  farm::Program program_{"x86-64", "1", "gcc", "0", {"./program"}, "0"};
};

// ---- the trials ------------------------------------------------------------------------------------------------------------------------------

void wait_busily(std::chrono::microseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  if (time > std::chrono::microseconds(500)) ::usleep(static_cast<useconds_t>(time.count() - 200));
  while (std::chrono::steady_clock::now() < end) {
  }
}

/// One child, killed after some acknowledged writes and a part of another one.
Heard kill_one(Kind& kind, Number first, std::mt19937_64& random, double& write_us) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError("no pipe can be made; free some descriptors");
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::close(ends[0]);
    kind.write(first, Reporter(ends[1]));
    ::_exit(1);
  }
  ::close(ends[1]);
  Heard heard;
  const auto take = [&](Number word) { ((word & 1) != 0 ? heard.done : heard.begun) = word >> 1; };
  const Number wanted = random() % 4;
  unsigned refused = 0;
  Number word = 0;
  auto begun = std::chrono::steady_clock::now();
  for (Number got = 0; got < wanted && ::read(ends[0], &word, sizeof word) == sizeof word;) {
    take(word);
    const auto now = std::chrono::steady_clock::now();
    if ((word & 1) == 0) {
      if (++refused > 100) throw InputError("a hundred writes were begun and none was acknowledged; see what the writer refuses");
      begun = now;
      continue;
    }
    refused = 0;
    ++got;
    write_us += 0.1 * (std::chrono::duration<double, std::micro>(now - begun).count() - write_us);
  }
  wait_busily(
      std::chrono::microseconds(static_cast<std::int64_t>(static_cast<double>(random() % 1000) / 1000 * 1.5 * std::min(write_us, 1e6))));
  ::kill(child, SIGKILL);
  while (::read(ends[0], &word, sizeof word) == sizeof word) take(word);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL) throw InputError("a child has ended by itself: it cannot write");
  return heard;
}

struct Named {
  const char* name;
  Number modulo;  ///< what `found` knows of the number; 0: all of it
  std::function<std::unique_ptr<Kind>(const fs::path&)> make;
};

template <class K>
Named named(const char* name, Number modulo = 0) {
  return {name, modulo, [](const fs::path& folder) { return std::make_unique<K>(folder); }};
}

const std::array<Named, 7> kKinds = {named<Uploads>("uploads", kBalls),  named<Calibrations>("calibrations"),
                                     named<RunMarks>("run-marks", 2),    named<Recordings>("recordings"),
                                     named<LastTickFiles>("last-ticks"), named<ToolFiles>("tool-files"),
                                     named<Answers>("farm-answers")};

/// returns   everything holds
bool try_kind(const Named& named, const fs::path& folder, unsigned kills, std::uint64_t seed) {
  fs::remove_all(folder / named.name);
  const std::unique_ptr<Kind> kind = named.make(folder / named.name);
  std::mt19937_64 random(seed);
  Number last = 0;
  unsigned within = 0;
  double write_us = 300;
  std::size_t files_early = 0;
  for (unsigned n = 0; n < kills; ++n) {
    const Number first = last + 1;
    const Heard heard = kill_one(*kind, first, random, write_us);
    if (kind->begins_anew()) last = 0;
    const Number done = std::max(heard.done, last), begun = std::max(heard.begun, done);
    within += begun > done ? 1 : 0;
    Verdict wrong;
    const Number found = kind->found(wrong);
    const auto is = [&](Number number) { return named.modulo == 0 ? found == number : found % named.modulo == number % named.modulo; };
    const bool none_yet = done == 0 && (found == 0 || (kind->begins_anew() && heard.begun == 0));
    if (wrong.empty() && !none_yet && !is(done) && !is(begun))
      wrong = "write " + std::to_string(done) + " was acknowledged and " + std::to_string(begun) + " begun, but " + std::to_string(found) +
              " is there";
    if (!wrong.empty()) {
      std::printf("%-13s kill %u of seed %llu: %s\n", named.name, n + 1, static_cast<unsigned long long>(seed), wrong.c_str());
      return false;
    }
    last = is(begun) ? begun : done;
    if (n == kills / 10) files_early = kind->files();
  }
  const std::size_t files = kind->files();
  std::printf("%-13s %u kills, %u of them within a write of about %.0f us, %zu files left\n", named.name, kills, within, write_us, files);
  if (files > files_early + 4)
    return std::printf("%-13s the folder grows: %zu files after a tenth of the kills, %zu now\n", named.name, files_early, files), false;
  if (within < kills / 20) return std::printf("%-13s too few kills fell within a write: nothing is shown\n", named.name), false;
  return true;
}

int run(const fs::path& folder, unsigned kills, std::uint64_t seed, const std::vector<std::string>& wanted) {
  unsigned passed = 0, failed = 0;
  for (const Named& kind : kKinds) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end()) continue;
    ++(try_kind(kind, folder, kills, seed) ? passed : failed);
    std::fflush(stdout);
  }
  std::printf("%u passed, %u failed, 0 skipped\n", passed, failed);
  return failed == 0 && passed > 0 ? 0 : 1;
}

}  // namespace
}  // namespace isotouch

int main(int argc, char** argv) try {
  if (argc < 3) return std::fprintf(stderr, "usage: kill_trials FOLDER KILLS [SEED [KIND...]]\n"), 2;
  const unsigned long kills = std::stoul(argv[2]);
  return isotouch::run(argv[1], static_cast<unsigned>(kills), argc > 3 ? std::stoull(argv[3]) : 1, {argv + std::min(argc, 4), argv + argc});
} catch (const std::exception& error) {
  return std::fprintf(stderr, "kill_trials: %s\n", error.what()), 1;
}
