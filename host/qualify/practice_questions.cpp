#include "host/qualify/practice_questions.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace isotouch::qualify {

namespace {

constexpr std::string_view kMissing = "missing:";

/// As the files that are asked for are named; a board may print anything.
bool is_path(std::string_view text) {
  const auto is_good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '/' || c == '_' || c == '.' || c == '-'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_good);
}

}  // namespace

std::string practice_command() {
  return "cd \"${ISOTOUCH_BOARD_ROOT:-/}\" || exit 1\n"
         "c=sys/devices/system/cpu\n"
         "grep -sH '' proc/version proc/interrupts proc/sys/kernel/sched_rt_*_us proc/irq/[0-9]*/*_affinity_list sys/kernel/realtime \\\n"
         "  sys/kernel/mm/transparent_hugepage/enabled $c/online $c/isolated $c/cpuidle/current_driver "
         "$c/cpu[0-9]*/cpufreq/scaling_governor \\\n"
         "  $c/cpu[0-9]*/cpufreq/scaling_driver $c/cpu[0-9]*/cpuidle/state*/name $c/cpu[0-9]*/cpuidle/state*/latency \\\n"
         "  $c/cpu[0-9]*/cpuidle/state*/time sys/bus/usb/devices/*/idVendor sys/bus/usb/devices/*/idProduct \\\n"
         "  sys/bus/usb/devices/*/power/control sys/bus/usb/devices/*/power/runtime_status | sed 's|^|/|'\n"
         "[ -r $c/isolated ] && echo /$c/isolated:\n"  // an empty file has no line
         "[ -r dev/cpu_dma_latency ] && v=$(od -An -td4 -N4 dev/cpu_dma_latency 2>/dev/null) && [ -n \"$v\" ] && echo "
         "/dev/cpu_dma_latency:$v\n"
         "for f in proc/version proc/interrupts proc/irq proc/sys/kernel/sched_rt_runtime_us proc/sys/kernel/sched_rt_period_us "
         "$c/isolated \\\n"
         "  $c/cpu0/cpufreq $c/cpuidle dev/cpu_dma_latency sys/bus/usb/devices sys/kernel/mm/transparent_hugepage/enabled; do\n"
         "  [ -e $f ] || echo missing:/$f\ndone\n"
         "for p in $(grep -slx isotouchd proc/[0-9]*/comm); do\n"
         "  t=$(grep -slxE 'tick|exchange|watchdog' ${p%comm}task/[0-9]*/comm) || continue\n"
         "  for f in $t; do\n"
         "    read -r n <$f && read -r s <${f%comm}stat && printf 'thread/%s/stat:%s\\n' \"$n\" \"$s\"\n"
         "    sed -n \"s|^Cpus_allowed_list:[[:space:]]*|thread/$n/cores:|p\" ${f%comm}status\n"
         "  done\n  break\ndone\n"
         "grep -sH '(irq/' proc/[0-9]*/stat | sed 's|^proc|irq_thread|'\n"
         "read -r n <proc/2/comm && printf 'kernel_thread:%s\\n' \"$n\"\n"
         "[ -e etc/default/grub ] && echo grub:\n"
         "echo machine:$(uname -m)";
}

BoardFiles read_practice(const std::string& text) {
  BoardFiles files;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kMissing)) {
      if (const std::string path = line.substr(kMissing.size()); is_path(path)) files.missing.insert(path);
      continue;
    }
    const auto colon = line.find(':');
    if (colon == std::string::npos || !is_path(std::string_view(line).substr(0, colon))) continue;
    const auto [at, fresh] = files.texts.try_emplace(line.substr(0, colon));
    if (!fresh) at->second += '\n';
    at->second.append(line, colon + 1);
  }
  return files;
}

}  // namespace isotouch::qualify
