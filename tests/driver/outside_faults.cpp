#include "tests/driver/outside_faults.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "firmware/control/control_server.h"
#include "firmware/control/control_socket.h"
#include "firmware/core/tick.h"
#include "firmware/loop/linux_clock.h"
#include "firmware/recording/recorder.h"
#include "firmware/store/field_intake.h"
#include "shared/files/trace_file.h"
#include "tests/driver/fault_bench.h"
#include "tests/support/full_disk.h"

namespace isotouch::test {

namespace {

constexpr const char* kGoesOn = "nothing to recover from";

/// A folder that goes with its owner.
struct Folder {
  Folder() : path((std::filesystem::temp_directory_path() / "isotouch-XXXXXX").string()) {
    if (mkdtemp(path.data()) == nullptr) path.clear();
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    if (!path.empty()) std::filesystem::remove_all(path, ignored);
  }
  std::string path;
};

/// So many ticks, all with commands.
bool presses_on(FaultBench& bench, int ticks) {
  bool always = true;
  for (int t = 0; t < ticks; ++t) {
    bench.tick();
    always &= bench.has_words() && bench.state() == SupervisorState::kActive;
  }
  return always;
}

/// Says half of an upload and is gone.
std::string say_half(const std::string& socket_path) {
  const int socket = control::connect_to_socket(socket_path);
  if (socket < 0) return "no connection";
  std::vector<std::uint8_t> frame(protocol::kMaxFrame), heard(1 << 16);
  const std::vector<std::uint8_t> piece(10'000, 7);
  const auto exchange = [&](std::size_t size) {
    return ::send(socket, frame.data(), size, MSG_NOSIGNAL) == static_cast<ssize_t>(size) &&
           ::recv(socket, heard.data(), heard.size(), 0) > 0;
  };
  bool said = exchange(protocol::encode(protocol::Kind::kHello, protocol::Hello{}, frame)) &&
              exchange(protocol::encode(protocol::Kind::kBegin, protocol::Begin{40'000, 60'000, 1, protocol::Text::of("half")}, frame)) &&
              exchange(protocol::encode(protocol::Kind::kChunk, protocol::Chunk{0, piece}, frame));
  ::close(socket);
  return said ? "" : "the upload did not begin";
}

FaultRow host_killed() {
  FaultRow row{"host killed in the middle of an upload", -1, "active", "none here: the field before stays", kGoesOn, ""};
  FaultBench bench({});
  const Folder folder;
  loop::LinuxClock clock;
  loop::Latest<loop::TickRecord> shown;
  store::FieldIntake intake(bench.fields, nullptr, clock, {});
  control::ControlSettings settings;
  settings.path = folder.path + "/control";
  settings.program = "a test";
  control::ControlServer server(settings, {intake, bench.commands, bench.stats, shown, clock});
  row.broken = bench.begin() ? server.start().sentence() : "the hand never pressed";
  if (!row.broken.empty()) return row;
  const std::uint32_t generation = bench.last.in.field_generation;
  row.broken = say_half(settings.path);
  for (int part = 0; part < 10 && row.broken.empty(); ++part) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the server hears of it meanwhile
    if (!presses_on(bench, 100) || bench.last.in.field_generation != generation) row.broken = "the ticks felt it";
  }
  server.stop();
  return row;
}

/// returns   why a recording is not just so many ticks that come to the same bits again; empty: it is
std::string why_not_replayed(const std::string& path, const FieldView& field, std::uint64_t ticks) {
  files::TraceFile trace;
  if (const Refusal refusal = files::read_trace(path, trace)) return refusal.sentence();
  const TraceHeader& header = trace.header();
  const core::TickModel model = core::make_tick_model(header.device, header.settings, header.period_ns);
  core::TickState state;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    const FieldView* felt = record.input.field_generation == 0 ? nullptr : &field;
    if (core::tick(record.input, felt, model, state) != record.output) return "what was recorded does not replay";
  }
  if (header.field_hash != field.hash()) return "the recording names another field";
  return trace.size() == ticks ? "" : "not every tick that the disk took is in the recording";
}

FaultRow disk_full() {
  FaultRow row{"disk full while recording", -1, "active", "", kGoesOn, ""};
  FaultBench::Options options;
  options.path = [press = pressing_hand()](double ms) { return press(ms < 4000 ? ms : ms < 5500 ? 0 : ms - 5500); };
  FaultBench bench(options);
  if (!bench.begin()) return {row.fault, -1, "", "", "", "the hand never pressed"};
  const Folder folder;
  const std::string path = folder.path + "/felt.trace";
  constexpr std::uint64_t kRoom = 5'000;  // ticks: the commands are back
  TraceHeader header;
  header.device = bench.settings.device;
  header.period_ns = bench.settings.period_ns;
  header.settings = bench.settings.tick;
  const std::vector<std::uint8_t> image = ball_image(25);
  const FieldView field = *FieldView::parse(image);
  recording::Recorder recorder(
      {header, "", 10, 10}, bench.trace, nullptr, bench.commands, [&](std::uint32_t) { return field.hash(); },
      [&](const std::string& sentence) { row.sentence += sentence; });
  row.broken = recorder.start(path).sentence();
  {
    const FullDisk disk(trace_layout::kHeaderBytes + kRoom * trace_layout::kRecordBytes + 7);
    for (int t = 0; t < 6500; ++t) {  // a recording begins with a restart: commands return when the hand has been out once
      bench.tick();
      recorder.drain();
    }
    if (row.broken.empty() && !presses_on(bench, 300)) row.broken = "the ticks felt it";
    recorder.drain();
    recorder.stop(0);
  }
  if (row.broken.empty() && row.sentence.empty()) row.broken = "nobody was told";
  if (row.broken.empty()) row.broken = why_not_replayed(path, field, kRoom);
  if (const std::size_t at = row.sentence.find(folder.path); at != std::string::npos) row.sentence.replace(at, folder.path.size() + 1, "");
  return row;
}

bool has_torque(FaultBench& bench) { return bench.falcon().firmware().commands() != falcon_model::Commands{}; }

FaultRow told_to_end() {
  FaultRow row{"SIGTERM, a crash of another thread, the end",  -1, "ended", "at the end, state: active",
               "started anew: homing if the firmware is lost", ""};
  FaultBench bench({});
  if (!bench.begin() || !has_torque(bench)) row.broken = "the hand never pressed";
  const std::uint64_t before = bench.falcon().packets();
  bench.port.rest();
  if (has_torque(bench)) row.broken = "the device was left with torque";
  row.ticks = static_cast<int>(bench.falcon().packets() - before) - 2;  // the first of three packets rests it
  bench.watch.leave();
  if (bench.lines.out != loop::LineOutputs{}) row.broken = "the lines were left on";
  return row;
}

/// Nothing is sent any more: what the motors do is the device's own.
FaultRow killed() {
  FaultRow row{"SIGKILL", -1, "gone", "", "", ""};
  FaultBench bench({});
  if (!bench.begin() || !has_torque(bench)) row.broken = "the hand never pressed";
  int ms = 0;
  for (; has_torque(bench) && ms < 100; ++ms) bench.falcon().silence(1);
  row.sentence = "none; the device's own time limit rests the motors, here after " + std::to_string(ms) +
                 " ms; the heartbeat stops, and a relay opens";
  row.recovery = "started anew by systemd; a fault until a person resumes";
  if (ms != 10) row.broken = "the simulated device's time limit is 10 ms";
  return row;
}

}  // namespace

std::vector<FaultRow> outside_faults() { return {host_killed(), disk_full(), told_to_end(), killed()}; }

}  // namespace isotouch::test
