#include "firmware/daemon/status_lines.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "firmware/loop/realtime.h"
#include "shared/fault_names.h"

namespace isotouch::daemon {

namespace {

using Text = char[160];

std::string row(const char* name, const loop::Histogram& histogram) {
  const loop::Distribution d = histogram.read();
  if (d.total == 0) return {};
  const auto us = [&](std::uint32_t per_million) { return d.quantile_ns(per_million) / 1000.0; };
  Text text;
  std::snprintf(text, sizeof text, "%-14s p50 %9.1f  p99 %9.1f  p999 %9.1f  max %9.1f us\n", name, us(500'000), us(990'000), us(999'000),
                d.largest_ns / 1000.0);
  return text;
}

unsigned long long whole(const loop::Counter& counter) { return counter.value(); }

}  // namespace

std::string device_line(const falcon::PortReport& report) {
  switch (report.state) {
    case falcon::SessionState::kSearching:
      if (report.boots > 0 && !report.boot.running()) return "device: " + falcon::explain(report.boot);
      if (report.troubled) return std::string("device: looking for one; ") + describe(report.trouble);
      return "device: looking for one";
    case falcon::SessionState::kBooting: return "device: found, being brought up";
    case falcon::SessionState::kRunning: return std::string("device: running, serial ") + report.serial.data();
  }
  return {};
}

std::string supervisor_line(const files::Condition& condition, protocol::OtherAngles others) {
  return "state: " + files::state_text(condition, others, "isotouchctl");  // which is installed beside it
}

std::string settings_line(std::uint64_t checksum) {
  Text text;
  std::snprintf(text, sizeof text, "settings: checksum %016llx", static_cast<unsigned long long>(checksum));
  return text;
}

std::string field_line(std::string_view name, std::uint64_t hash) {
  Text text;
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return "field: " + std::string(name) + (name.empty() ? "" : ", ") + text;
}

std::string guard_line(GuardVerdict verdict) { return "the guard stopped a motor command " + std::string(name_of(verdict)); }

std::string memory_line(loop::Damage damage) {
  switch (damage) {
    case loop::Damage::kNone: return {};
    case loop::Damage::kState:
      return "what the tick remembers was damaged in memory; it began anew; somebody with the role service may run 'isotouchctl resume'";
    case loop::Damage::kField:
      return "the field in memory was damaged; send the field again, then somebody with the role service may run 'isotouchctl resume'";
    case loop::Damage::kPrepared: break;
  }
  return "the model of the device in memory was damaged; restart the controller";
}

std::string refusal_line(unsigned refused) {
  if (refused == 0) return {};
  std::string text;
  const auto add = [&](loop::Refusals bit, const char* name) {
    if ((refused & bit) != 0) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  add(loop::kRefusedPriority, "a real-time priority");
  add(loop::kRefusedCore, "a processor core");
  add(loop::kRefusedMemory, "locked memory");
  return "runs without " + text +
         ", because this user or machine may not have it: ticks may be late; start it as the service isotouchd, whose unit gives these "
         "rights";
}

std::string latency_line(const std::string& file, int error) {
  const std::string remedy = error == EACCES || error == EPERM ? "install 60-isotouch-latency.rules and be in the group isotouch"
                             : error == ENOTTY                 ? "name a character device in [loop] latency_file, or \"\""
                             : error == ENOENT
                                 ? "use a kernel with CONFIG_CPU_IDLE, or set [loop] latency_file = \"\" where processors never sleep"
                                 : "set [loop] latency_file = \"\" to do without it";
  const std::string why = error == ENOTTY ? "it is no character device" : std::strerror(error);
  return "processors may fall asleep while there is force, and ticks then begin late: " + file + " cannot be held (" + why + "); " + remedy;
}

std::vector<std::string> missing_lines(const settings::Settings& settings) {
  std::vector<std::string> missing;
  if (settings.line_stop < 0)
    missing.emplace_back("no emergency stop is set up, so only the program itself can stop the force; see [lines] stop and chip");
  if (settings.line_heartbeat < 0)
    missing.emplace_back(
        "no watchdog relay is set up, so only the device's own time limit ends the force if this program fails; see [lines] heartbeat and "
        "chip");
  return missing;
}

std::string no_state_line() {
  return "no state folder is set up, so nothing remembers a crash or a fault: the next start gives force without 'resume'; "
         "name a folder in [files] state";
}

std::string ending_line(int signal) {
  const char* name = ::sigabbrev_np(signal);  // none for real-time signals
  return "the controller ends: " + (name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(signal));
}

std::string figures(const loop::TickStats& stats) {
  Text text;
  std::snprintf(text, sizeof text, "ticks %llu, fresh %llu, stale %llu (oldest %llu), started by a reply %llu, late %llu, missed %llu\n",
                whole(stats.ticks), whole(stats.fresh), whole(stats.stale), whole(stats.largest_age), whole(stats.by_reply),
                whole(stats.late), whole(stats.missed));
  std::string all = text;
  all += row("wake delay", stats.wake_delay) + row("tick", stats.tick_time) + row("round trip", stats.round_trip) +
         row("reply to motor", stats.word_delay);
  std::snprintf(text, sizeof text, "since the first tick: page faults %llu, allocations %llu\n", whole(stats.page_faults),
                whole(stats.allocations));
  return all + text;
}

}  // namespace isotouch::daemon
