#include "host/qualify/board_questions.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string_view>
#include <system_error>

#include "host/qualify/board_files.h"

namespace isotouch::qualify {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

constexpr std::size_t kMaxShown = 4096;  // bytes of one text of the board: the longest list of boot options

/// The kernel's folder for tracing, where this user may make a buffer in it; ISOTOUCH_TRACING names another one.
constexpr std::string_view kFindTracer =
    "t=${ISOTOUCH_TRACING:-/sys/kernel/tracing}; [ -d $t/instances ] || t=/sys/kernel/debug/tracing\n"
    "i=$t/instances/isotouch\n";

}  // namespace

std::string describe_command() {
  return "echo \"kernel=$(uname -sr) $(uname -v)\"; echo \"processor=$(uname -m), $(nproc 2>/dev/null || echo '?')\"\n"
         "[ -r /proc/device-tree/model ] && echo \"model=$(tr -d '\\000' </proc/device-tree/model)\"\n"
         "[ -r /sys/kernel/realtime ] && echo \"real-time kernel=$(cat /sys/kernel/realtime)\"\n"
         "echo \"boot options=$(cat /proc/cmdline 2>/dev/null)\"\n"
         "g=/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor; [ -r $g ] && echo \"frequency governor=$(cat $g)\"\n"
         "echo \"load=$(cut -d' ' -f1-3 /proc/loadavg)\"; true";
}

std::vector<std::pair<std::string, std::string>> read_description(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& line : lines_of(text)) {
    const auto equals = line.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == line.size()) continue;
    pairs.emplace_back(shown(line.substr(0, equals), kMaxShown), shown(line.substr(equals + 1), kMaxShown));
  }
  return pairs;
}

std::string sensors_command() {
  return "for f in /sys/class/thermal/thermal_zone*/temp; do [ -e $f ] && echo \"millicelsius $(cat $f)\"; done 2>/dev/null\n"
         "for f in /sys/devices/system/cpu/cpu[0-9]*/cpufreq/scaling_cur_freq; do [ -r $f ] && echo \"kilohertz $(cat $f)\"; done "
         "2>/dev/null; true";
}

Sensors read_sensors(const std::string& text, Moment& moment) {
  Sensors sensors;
  for (const std::string& line : lines_of(text)) {
    double value = 0;
    if (std::sscanf(line.c_str(), "millicelsius %lf", &value) == 1) {
      moment.celsius = std::max(value / 1000, moment.celsius.value_or(-273));
      ++sensors.read;
    } else if (line.starts_with("millicelsius")) {
      ++sensors.silent;
    }
    if (std::sscanf(line.c_str(), "kilohertz %lf", &value) == 1) moment.megahertz = std::min(value / 1000, moment.megahertz.value_or(1e9));
  }
  return sensors;
}

std::string timer_command(int priority, std::uint32_t period_us, double seconds) {
  const std::string options = "--default-system $a -q -m -p " + std::to_string(priority) + " -i " + std::to_string(period_us) +
                              " -h 20000 -D " + std::to_string(static_cast<int>(std::ceil(seconds)));
  return "command -v cyclictest >/dev/null || { echo 'cyclictest is not installed there (package rt-tests)'; exit 3; }\n"
         "t=$(grep -lx tick /proc/[0-9]*/task/[0-9]*/comm 2>/dev/null | head -1)\n"
         "a=$(sed -nE 's/^Cpus_allowed_list:[[:space:]]*([0-9]+)$/--affinity=\\1/p' \"${t%comm}status\" 2>/dev/null)\n"
         "o=$(cyclictest " +
         options + " 2>&1) || { echo \"$o\" | grep -v '^#' | head -1; exit 4; }\necho \"$o\" | grep -v ' 000000$'";
}

std::optional<link::Histogram> read_timer(int status, const std::string& text, std::string& why) {
  if (status != 0) {
    const auto lines = lines_of(text);
    why = lines.empty() ? "" : shown(lines[0], kMaxShown);
    if (why.empty()) why = "cyclictest failed there";
    return std::nullopt;
  }
  link::Histogram histogram;
  std::uint64_t beyond = 0, most_us = 0;
  for (const std::string& line : lines_of(text)) {
    unsigned long long us = 0, count = 0;
    if (std::sscanf(line.c_str(), "# Max Latencies: %llu", &us) == 1) most_us = us;
    if (std::sscanf(line.c_str(), "# Histogram Overflows: %llu", &count) == 1) beyond = count;
    if (line.empty() || std::isdigit(static_cast<unsigned char>(line[0])) == 0) continue;
    if (std::sscanf(line.c_str(), "%llu %llu", &us, &count) != 2 || count == 0) continue;
    histogram.count += count;
    histogram.bins.push_back({static_cast<std::uint32_t>((us + 1) * 1000), count});  // whole microseconds, cut off
  }
  if (beyond > 0) {
    histogram.count += beyond;
    histogram.bins.push_back({static_cast<std::uint32_t>(std::min<std::uint64_t>((most_us + 1) * 1000, UINT32_MAX)), beyond});
  }
  if (histogram.count > 0) return histogram;
  why = "cyclictest counted nothing there";
  return std::nullopt;
}

std::string eviction_command(double seconds) {
  const std::string s = std::to_string(static_cast<int>(std::ceil(seconds)));
  return "t=timeout; timeout --foreground 1 true 2>/dev/null && t='timeout --foreground'\n"  // it stays in the group that is ended
         "n=$(nproc 2>/dev/null || echo 1); [ $n -le 8 ] || n=8\n"
         "i=0; while [ $i -lt $n ]; do i=$((i + 1)); nice -n 19 $t " +
         s + " dd if=/dev/zero of=/dev/null bs=$((64 / n))M 2>/dev/null & done; wait";
}

std::string begin_tracing_command() {
  return std::string(kFindTracer) +
         "mkdir $i 2>/dev/null || [ -d $i ] || exit 1\n"
         "cd $i && echo 0 >tracing_on && echo mono >trace_clock && echo 1024 >buffer_size_kb && echo 1 >events/sched/sched_switch/enable "
         "&&\n"
         "echo 1 >events/irq/irq_handler_entry/enable && echo 1 >events/irq/softirq_entry/enable && echo 1 >tracing_on ||\n"
         "{ cd / && rmdir $i; exit 1; }";
}

std::string end_tracing_command() { return std::string(kFindTracer) + "[ ! -d $i ] || rmdir $i"; }

std::string trace_command(std::span<const protocol::WorstTick> ticks) {
  // A millisecond before, because the last switch tells who had the processor; the tracer's times are whole microseconds.
  std::string windows;
  for (const protocol::WorstTick& tick : ticks) {
    const double begun = static_cast<double>(tick.start_ns) / 1e9, due = begun - tick.wake_ns / 1e9;
    char window[80];
    std::snprintf(window, sizeof window, "%.6f %.6f %.6f ", due, due - 0.001, begun + 0.000002);
    windows += window;
  }
  // It stands while it is read, or the reader would never catch up; and the reader takes nothing from the ticks.
  return std::string(kFindTracer) +
         "trap : TERM; echo 0 >$i/tracing_on\n"  // its end is waited for: a tracer that is read cannot be removed
         "nice -n 19 timeout 10 awk -v windows='" +
         windows +
         "' 'BEGIN { n = split(windows, w, \" \"); for (i = 3; i <= n; i += 3) if (w[i] + 0 > last) last = w[i] + 0 }\n"
         "   /^#/ { next }\n"
         "   match($0, / [0-9]+\\.[0-9]+: /) {\n"
         "     t = substr($0, RSTART + 1, RLENGTH - 3) + 0\n"
         "     if (t > last) exit\n"
         "     for (i = 1; i < n; i += 3) if (t >= w[i + 1] + 0 && t <= w[i + 2] + 0)\n"
         "       print (i + 2) / 3, (t < w[i] + 0 ? \"before\" : \"since\"), $0 }' $i/trace\n"
         "r=$?; echo 1 >$i/tracing_on; exit $r";
}

namespace {

/// Of one tick: its lines without its number.
std::string read_cause(const std::vector<std::string>& lines) {
  // The processor is that of the last switch to the tick.
  static const std::regex kEvent(R"(^(before|since) .*\[(\d+)\] .*: (sched_switch|irq_handler_entry|softirq_entry): (.*)$)");
  static const std::regex kNext(R"(prev_comm=(.*) prev_pid=.* prev_state=(\S+) ==> next_comm=(.*) next_pid=)");
  static const std::regex kIrq(R"(irq=(\d+) name=(.*))"), kSoftirq(R"(action=(\w+))");
  struct Event {
    bool since;
    std::string processor, kind, rest;
  };
  std::vector<Event> events;
  std::string processor;
  for (const std::string& line : lines) {
    std::smatch m, names;
    if (!std::regex_match(line, m, kEvent)) continue;
    events.push_back({m[1] == "since", m[2], m[3], m[4]});
    const std::string rest = m[4];
    if (m[3] == "sched_switch" && std::regex_search(rest, names, kNext) && names[3] == "tick") processor = m[2];
  }
  if (processor.empty()) return {};
  std::vector<std::string> seen;
  const auto add = [&](const std::string& what) {
    if (what != "tick" && std::find(seen.begin(), seen.end(), what) == seen.end()) seen.push_back(what);
  };
  std::string running;
  for (const Event& event : events) {
    std::smatch m;
    // The tick itself went to rest after this one was due, wherever it ran.
    if (event.since && event.kind == "sched_switch" && std::regex_search(event.rest, m, kNext) && m[1] == "tick" && m[2].str()[0] != 'R')
      add("the tick before");
    if (event.processor != processor) continue;
    if (event.kind == "sched_switch" && std::regex_search(event.rest, m, kNext)) {
      if (event.since) add(m[1].str().starts_with("swapper") ? "idle" : m[1].str());
    } else if (event.since && event.kind == "irq_handler_entry" && std::regex_search(event.rest, m, kIrq)) {
      add("interrupt " + m[1].str() + " (" + m[2].str() + ")");
    } else if (event.since && event.kind == "softirq_entry" && std::regex_search(event.rest, m, kSoftirq)) {
      add("softirq " + m[1].str());
    }
  }
  std::string text_of;
  for (const std::string& what : seen) text_of += (text_of.empty() ? "" : ", ") + what;
  if (text_of == "idle") return "nothing else ran: the processor slept";
  return text_of.empty()
             ? text_of
             : "processor " + processor.substr(std::min(processor.find_first_not_of('0'), processor.size() - 1)) + ": " + text_of;
}

}  // namespace

std::vector<std::string> read_causes(const std::string& text, std::size_t ticks) {
  std::vector<std::vector<std::string>> lines(ticks);
  for (const std::string& line : lines_of(text)) {
    std::size_t tick = 0;
    const auto [end, failed] = std::from_chars(line.data(), line.data() + line.size(), tick);
    if (failed == std::errc() && tick >= 1 && tick <= ticks && *end == ' ')
      lines[tick - 1].push_back(line.substr(static_cast<std::size_t>(end + 1 - line.data())));
  }
  std::vector<std::string> causes;
  causes.reserve(ticks);
  for (const std::vector<std::string>& one : lines) causes.push_back(shown(read_cause(one), kMaxShown));
  return causes;
}

}  // namespace isotouch::qualify
