#include "host/qualify/practice.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "host/qualify/board_files.h"
#include "host/qualify/finding.h"
#include "host/qualify/practice_interrupts.h"

namespace isotouch::qualify {

namespace {

using enum Finding::Verdict;

Finding kernel(const Board& board) {
  const Ask ask{"kernel", "kernel"};
  const std::string* version = board.text("/proc/version");
  const std::string* realtime = board.text("/sys/kernel/realtime");
  if (version == nullptr) return ask.not_read(board, "/proc/version");
  if (!version->starts_with("Linux version ")) return ask.garbled_file("/proc/version", *version);
  const auto has = [&](const char* word) { return version->find(word) != std::string::npos; };
  const std::string begin = shown(version->substr(0, version->find(" (")));
  const std::string* machine = board.text("machine");
  const std::string is = machine == nullptr ? "" : *machine;
  const std::string flavour = is == "x86_64" ? "amd64" : is == "aarch64" ? "arm64" : is.starts_with("armv7") ? "armmp" : "";
  const std::string remedy = flavour.empty() ? "Build a kernel with CONFIG_PREEMPT_RT, or install the one of your distribution."
                                             : "On Debian: sudo apt install linux-image-rt-" + flavour + " && sudo reboot";
  if ((realtime != nullptr && whole_number(*realtime) == 1) || has("PREEMPT_RT") || has("PREEMPT RT"))
    return ask.good(begin + ", PREEMPT_RT",
                    "This kernel is real-time: a thread with a high priority interrupts almost everything at once.");
  if (has("PREEMPT"))
    return ask.better(begin + (has("PREEMPT_DYNAMIC") ? ", PREEMPT_DYNAMIC" : ", PREEMPT"),
                      "This kernel is not real-time: interrupts and parts of the kernel hold a tick up.", remedy);
  return ask.bad(begin + ", no preemption", "This kernel holds a tick up until a system call of another program is done.", remedy);
}

Finding tick_priority(const Board& board) {
  const Ask ask{"tick_priority", "priority of the tick"};
  const auto tick = board.thread("tick");
  if (!tick) return ask.no_controller();
  if (tick->is_real_time()) return ask.good(tick->text(), "The tick runs before every ordinary program.");
  return ask.bad("ordinary scheduling", "Any program can hold the tick up.",
                 "Run the controller as a service (sudo systemctl enable --now isotouchd), or give its user the right: "
                 "echo \"$USER - rtprio 90\" | sudo tee /etc/security/limits.d/isotouch.conf");
}

Finding isolated_cores(const Board& board) {
  const Ask ask{"isolated_cores", "isolated cores"};
  const char* path = "/sys/devices/system/cpu/isolated";
  const std::string* text = board.text(path);
  const auto isolated = text == nullptr ? std::nullopt : processors(*text);
  if (!isolated) return text == nullptr ? ask.not_read(board, path) : ask.garbled_file(path, *text);
  const std::string read = isolated->empty() ? "none" : list_of(*isolated);
  const auto cores = board.cores("tick");
  if (!cores) return ask.no_controller(read);
  if (const auto online = board.online(); online && online->size() == 1)
    return ask.better(read, "There is one core, which the tick shares with everything else.", "Use a board with two or more cores.");
  if (cores->size() != 1)
    return ask.better(
        read + "; the tick may run on " + list_of(*cores), "The tick is not bound to a core, so it has none for itself.",
        "Set [loop] core = " + std::to_string(board.best_core()) + " in the settings, then: sudo systemctl restart isotouchd");
  const std::string core = list_of(*cores);
  if (isolated->count(*cores->begin()) != 0)
    return ask.good(read + "; the tick has " + core, "The kernel puts no other program on the tick's core.");
  const std::string option = "isolcpus=managed_irq,domain," + core;
  return ask.better(
      read + "; the tick has " + core, "Other programs run on the tick's core.",
      board.text("grub") != nullptr
          ? "Run: sudo sed -i 's/^GRUB_CMDLINE_LINUX=\"/&" + option + " /' /etc/default/grub && sudo update-grub && sudo reboot"
          : "Add " + option + " to the kernel's boot options (Raspberry Pi: /boot/firmware/cmdline.txt), then: sudo reboot");
}

Finding throttling(const Board& board) {
  const Ask ask{"rt_throttling", "real-time throttling"};
  const char *runtime_path = "/proc/sys/kernel/sched_rt_runtime_us", *period_path = "/proc/sys/kernel/sched_rt_period_us";
  const std::string* text = board.text(runtime_path);
  if (text == nullptr) return ask.not_read(board, runtime_path);
  const auto runtime = whole_number(*text);
  if (!runtime || *runtime < -1) return ask.garbled_file(runtime_path, *text);
  if (*runtime == -1) return ask.good("off", "The kernel never stops a real-time thread.");
  const std::string* period_text = board.text(period_path);
  if (period_text == nullptr) return ask.not_read(board, period_path);
  const auto period = whole_number(*period_text);
  if (!period || *period <= 0) return ask.garbled_file(period_path, *period_text);
  const std::string read = std::to_string(*runtime) + " of " + std::to_string(*period) + " us";
  const std::string remedy = "Run: echo kernel.sched_rt_runtime_us=-1 | sudo tee /etc/sysctl.d/60-isotouch.conf && sudo sysctl --system";
  constexpr double kPlenty = 0.9;
  if (static_cast<double>(*runtime) < kPlenty * static_cast<double>(*period))
    return ask.bad(read, "Real-time threads, the tick among them, stop when all of them together have run for this time in a period.",
                   remedy);
  return ask.better(read, "If one real-time thread does not rest, the kernel stops all of them for the rest of the period, the tick too.",
                    remedy);
}

Finding governor(const Board& board) {
  const Ask ask{"governor", "frequency governor"};
  const std::string folder = "/sys/devices/system/cpu/cpu0/cpufreq", begin = "/sys/devices/system/cpu/cpu";
  static const std::set<std::string> kKnown = {"performance", "powersave",   "ondemand", "conservative",
                                               "schedutil",   "interactive", "userspace"};
  std::set<std::string> seen;
  bool scales_itself = false;
  for (const auto& [path, text] : board.under(begin, "/cpufreq/scaling_governor")) {
    if (kKnown.count(text) == 0) return ask.garbled_file(path, text);
    seen.insert(text);
  }
  for (const auto& [path, text] : board.under(begin, "/cpufreq/scaling_driver"))
    scales_itself = scales_itself || text.starts_with("intel_pstate") || text.starts_with("amd-pstate");
  if (seen.empty()) return ask.not_read(board, folder);
  std::string read;
  for (const std::string& name : seen) read += (read.empty() ? "" : ", ") + name;
  if (read == "performance") return ask.good(read, "Processors keep their highest clock rate.");
  const std::string remedy = "Run: echo performance | sudo tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor";
  if (seen.count("powersave") != 0 && !scales_itself) return ask.bad(read, "Processors keep their lowest clock rate.", remedy);
  return ask.better(read, "Processors change their clock rate: a tick after a rest is slower, and the change itself takes time.", remedy);
}

Finding idle_states(const Board& begin, const Board& board, double wakeup_us) {
  const Ask ask{"idle_states", "deepest idle state"};
  const std::string folder = "/sys/devices/system/cpu/cpuidle", begin_of = "/sys/devices/system/cpu/cpu", state_end = "/latency";
  constexpr std::int64_t kShallowUs = 10;
  std::int64_t deepest = -1;
  std::string name = "none";
  bool looked = false;
  for (const auto& [path, text] : board.under(begin_of, state_end)) {
    const std::string state = path.substr(0, path.size() - state_end.size());
    const auto at = state.find("/cpuidle/state");
    if (at == std::string::npos) continue;
    const auto core = whole_number(state.substr(begin_of.size(), at - begin_of.size()));
    if (!core || !board.may_run_threads(static_cast<int>(std::clamp<std::int64_t>(*core, -1, INT32_MAX)))) continue;
    const std::string *before = begin.text(state + "/time"), *after = board.text(state + "/time"), *label = board.text(state + "/name");
    if (before == nullptr || after == nullptr) return ask.not_read(board, state + "/time");
    const auto slept_before = whole_number(*before), slept_after = whole_number(*after), latency = whole_number(text);
    if (!slept_before || !slept_after || *slept_before < 0 || *slept_after < *slept_before || !latency || *latency < 0)
      return ask.garbled_file(state + "/time", *before + " " + *after + " " + text);
    looked = true;
    if (*slept_after > *slept_before && *latency > deepest) deepest = *latency, name = label == nullptr ? "" : shown(*label, 20);
  }
  const std::string* driver = board.text(folder + "/current_driver");
  if (!looked || (driver != nullptr && *driver == "haltpoll")) {  // a virtual machine's, whose host decides how long it takes to wake up
    return driver == nullptr
               ? ask.not_read(board, folder)
               : ask.not_known("The kernel's idle driver is '" + shown(*driver, 20) + "', which does not tell how deep processors sleep.",
                               "On a virtual machine there is nothing to do here; see whether its host lets processors sleep.");
  }
  const std::string read = deepest < 0 ? "none" : name + ", " + std::to_string(deepest) + " us to wake up";
  if (deepest <= kShallowUs) return ask.good(read, "No processor of the controller slept deeply while it was measured.");
  const std::string remedy =
      "Check below whether /dev/cpu_dma_latency is held. The controller holds it only in the states idle, ready, active and hold, so "
      "measure in one of these.";
  const std::string why = "A processor of the controller slept so deeply that a tick may begin late by this time.";
  return static_cast<double>(deepest) <= wakeup_us ? ask.better(read, why, remedy) : ask.bad(read, why, remedy);
}

Finding latency_file(const Board& board) {
  const Ask ask{"latency_file", "/dev/cpu_dma_latency"};
  const char* path = "/dev/cpu_dma_latency";
  const std::string* text = board.text(path);
  if (text == nullptr) return ask.not_read(board, path);
  const auto us = whole_number(*text);
  if (!us || *us < 0) return ask.garbled_file(path, *text);
  constexpr std::int64_t kAwakeUs = 10, kNobodyUs = 2'000'000'000;
  if (*us <= kAwakeUs)
    return ask.good("held at " + std::to_string(*us) + " us",
                    "A program, most likely the controller, keeps the processors out of deep idle states.");
  return ask.better(
      *us >= kNobodyUs ? "held by nobody" : "held at " + std::to_string(*us) + " us",
      "Nothing keeps the processors out of deep idle states: the controller does so while force is possible.",
      "Let the controller open the file: sudo udevadm control --reload && sudo udevadm trigger && sudo systemctl restart isotouchd; "
      "then see journalctl -u isotouchd");
}

Finding autosuspend(const Board& board) {
  const Ask ask{"usb_autosuspend", "USB autosuspend"};
  const std::string folder = "/sys/bus/usb/devices";
  for (const auto& [path, vendor] : board.under(folder + "/", "/idVendor")) {
    const std::string device = path.substr(0, path.size() - std::string("/idVendor").size());
    const std::string* product = board.text(device + "/idProduct");
    if (vendor != "0403" || product == nullptr || *product != "cb48") continue;
    const std::string control_path = device + "/power/control";
    const std::string *control = board.text(control_path), *status = board.text(device + "/power/runtime_status");
    if (control == nullptr) return ask.not_read(board, control_path);
    if (*control == "on") return ask.good("on", "The kernel never puts the Falcon to sleep.");
    if (*control != "auto") return ask.garbled_file(control_path, *control);
    const std::string remedy = "Run: echo on | sudo tee " + shown(control_path) + "; to keep it so, install 60-isotouch-falcon.rules.";
    if (status != nullptr && *status == "suspended") return ask.bad("auto, suspended", "The Falcon is asleep, and cannot answer.", remedy);
    return ask.better("auto", "The kernel may put the Falcon to sleep while nobody uses it, and it then takes time to answer.", remedy);
  }
  if (board.is_missing(folder)) return ask.not_read(board, folder);
  return ask.not_known("No Falcon is on this machine's USB.", "Connect the Falcon and measure again; a simulated one needs nothing here.");
}

Finding huge_pages(const Board& board) {
  const Ask ask{"huge_pages", "transparent huge pages"};
  const char* path = "/sys/kernel/mm/transparent_hugepage/enabled";
  const std::string* text = board.text(path);
  if (text == nullptr) return ask.not_read(board, path);
  const auto open = text->find('['), close = text->find(']');
  const std::string chosen =
      open == std::string::npos || close == std::string::npos || close < open ? "" : text->substr(open + 1, close - open - 1);
  if (chosen == "never" || chosen == "madvise")
    return ask.good(chosen, "The kernel does not move the controller's memory to make huge pages.");
  if (chosen != "always") return ask.garbled_file(path, *text);
  return ask.better(
      "always", "The kernel may move memory of the controller to make huge pages, and a tick waits meanwhile.",
      std::string("Run: echo madvise | sudo tee ") + path + "; to keep it so, add transparent_hugepage=madvise to the boot options.");
}

}  // namespace

std::vector<Finding> judge_practice(const BoardFiles& begin, const BoardFiles& end, double wakeup_us) {
  const Board before(begin), board(end);
  return {kernel(board),         tick_priority(board), xhci_priority(board), irq_affinity(board),
          isolated_cores(board), throttling(board),    governor(board),      idle_states(before, board, wakeup_us),
          latency_file(board),   autosuspend(board),   huge_pages(board)};
}

const char* name_of(Finding::Verdict verdict) {
  switch (verdict) {
    case kGood: return "good";
    case kCouldBeBetter: return "could be better";
    case kBad: return "bad";
    case kNotRead: break;
  }
  return "could not be read";
}

}  // namespace isotouch::qualify
