#include "host/qualify/practice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/qualify/practice_questions.h"

namespace isotouch::qualify {
namespace {

using testing::HasSubstr;
using enum Finding::Verdict;

constexpr double kWakeupUs = 100;

std::string stat(const std::string& name, int priority, int policy) {
  return "50 (" + name +
         ") S 2 0 0 0 -1 2129984 0 0 0 0 0 0 0 0 -51 0 1 0 42 0 0 18446744073709551615 0 0 0 0 0 0 0 2147483647 0 1 0 0 17 0 " +
         std::to_string(priority) + " " + std::to_string(policy) + " 0 0 0 0 0 0 0 0 0 0 0";
}

const std::string kCpu = "/sys/devices/system/cpu/", kFalcon = "/sys/bus/usb/devices/1-1.2/";

/// A board of four cores with a real-time kernel, on which everything is well: texts as its kernel writes them.
BoardFiles good_files() {
  BoardFiles files;
  files.texts = {
      {"machine", "aarch64"},
      {"kernel_thread", "kthreadd"},
      {"/proc/version", "Linux version 6.12.38-rt11 (me@pc) (aarch64-linux-gnu-gcc 12.2.0) #1 SMP PREEMPT_RT Mon Jul 14 12:00:00 UTC 2025"},
      {"/sys/kernel/realtime", "1"},
      {"/proc/interrupts",
       "           CPU0       CPU1       CPU2       CPU3\n"
       " 11:   12345678   22345678   32345678   42345678     GICv2  30 Level     arch_timer\n"
       " 26:      10000          0          0          0     GICv2 189 Level     eth0\n"
       " 27:          0          0          0          0     GICv2 190 Level     never\n"
       " 51:     600000          0          0          0  BRCM STB PCIe MSI 524288 Edge      xhci_hcd\n"
       "IPI0:     1000       1000       1000       1000       Rescheduling interrupts\n"},
      {"/proc/irq/26/effective_affinity_list", "0"},
      {"/proc/irq/27/effective_affinity_list", "3"},
      {"/proc/irq/51/effective_affinity_list", "0"},
      {"irq_thread/90/stat", stat("irq/51-xhci_hcd", 76, 1)},
      {"irq_thread/91/stat", stat("irq/26-eth0", 50, 1)},
      {"thread/tick/stat", stat("tick", 80, 1)},
      {"thread/tick/cores", "3"},
      {"thread/exchange/stat", stat("exchange", 75, 1)},
      {"thread/exchange/cores", "2"},
      {"/sys/devices/system/cpu/online", "0-3"},
      {"/sys/devices/system/cpu/isolated", "3"},
      {"/proc/sys/kernel/sched_rt_runtime_us", "-1"},
      {"/proc/sys/kernel/sched_rt_period_us", "1000000"},
      {"/sys/devices/system/cpu/cpuidle/current_driver", "psci_idle"},
      {"/dev/cpu_dma_latency", "0"},
      {kFalcon + "idVendor", "0403"},
      {kFalcon + "idProduct", "cb48"},
      {kFalcon + "power/control", "on"},
      {kFalcon + "power/runtime_status", "active"},
      {"/sys/bus/usb/devices/usb1/idVendor", "1d6b"},
      {"/sys/bus/usb/devices/usb1/power/control", "auto"},
      {"/sys/kernel/mm/transparent_hugepage/enabled", "always [madvise] never"},
  };
  for (const char* cpu : {"cpu0", "cpu1", "cpu2", "cpu3"}) {
    const std::string folder = kCpu + cpu;
    files.texts[folder + "/cpufreq/scaling_governor"] = "performance";
    files.texts[folder + "/cpufreq/scaling_driver"] = "cpufreq-dt";
    files.texts[folder + "/cpuidle/state0/name"] = "WFI";
    files.texts[folder + "/cpuidle/state0/latency"] = "1";
    files.texts[folder + "/cpuidle/state0/time"] = "1000";
    files.texts[folder + "/cpuidle/state1/name"] = "cpu-sleep";
    files.texts[folder + "/cpuidle/state1/latency"] = "90";
    files.texts[folder + "/cpuidle/state1/time"] = "500";
  }
  return files;
}

BoardFiles at_begin() {
  BoardFiles files = good_files();
  for (auto& [path, text] : files.texts) {
    if (path.ends_with("state0/time")) text = "10";
  }
  return files;
}

using Spoil = std::function<void(BoardFiles&)>;

Finding find(const std::vector<Finding>& all, const std::string& key) {
  for (const Finding& f : all) {
    if (f.key == key) return f;
  }
  ADD_FAILURE() << "there is no finding " << key;
  return {};
}

/// The finding of this key, once the end of the measurement is spoiled; all others must stay good unless they are named.
Finding finding(const std::string& key, const Spoil& spoil) {
  BoardFiles files = good_files();
  spoil(files);
  return find(judge_practice(at_begin(), files, kWakeupUs), key);
}

Spoil with(const std::string& path, const std::string& text) {
  return [=](BoardFiles& files) { files.texts[path] = text; };
}

TEST(Practice, OnAGoodBoardEverythingIsGoodAndThereIsNothingToDo) {
  const auto all = judge_practice(at_begin(), good_files(), kWakeupUs);
  EXPECT_EQ(all.size(), 11U);
  for (const Finding& f : all) {
    EXPECT_EQ(f.verdict, kGood) << f.key << ": " << f.read << ": " << f.why;
    EXPECT_FALSE(f.read.empty()) << f.key;
    EXPECT_FALSE(f.why.empty()) << f.key;
    EXPECT_EQ(f.remedy, "") << f.key;
  }
}

TEST(Practice, WhereNothingCanBeReadNothingIsGood) {
  BoardFiles denied, missing;
  for (const auto& [path, text] : good_files().texts) missing.missing.insert(path);
  for (const char* folder :
       {"/proc/irq", "/sys/devices/system/cpu/cpu0/cpufreq", "/sys/devices/system/cpu/cpuidle", "/sys/bus/usb/devices"})
    missing.missing.insert(folder);
  for (const BoardFiles& files : {denied, missing}) {
    for (const Finding& f : judge_practice(files, files, kWakeupUs)) {
      EXPECT_EQ(f.verdict, kNotRead) << f.key;
      EXPECT_FALSE(f.why.empty()) << f.key;
      EXPECT_FALSE(f.remedy.empty()) << f.key;
    }
  }
  EXPECT_EQ(find(judge_practice(missing, missing, kWakeupUs), "governor").why,
            "There is no /sys/devices/system/cpu/cpu0/cpufreq on this machine.");
  EXPECT_EQ(find(judge_practice(denied, denied, kWakeupUs), "latency_file").why, "This user may not read /dev/cpu_dma_latency.");
}

struct Row {
  std::string key;
  Spoil spoil;
  Finding::Verdict verdict;
  std::string read, remedy;  ///< what stands in them
};

TEST(Practice, EachFindingSaysWhatWasReadAndWhatToDo) {
  const std::string kernel = "Linux version 6.1.0-18-arm64 (debian@x) (gcc) #1 SMP ";
  const auto both = [](const Spoil& one, const Spoil& other) { return [=](BoardFiles& files) { one(files), other(files); }; };
  const auto without = [](const std::string& path) { return [=](BoardFiles& files) { files.texts.erase(path); }; };
  const Spoil ordinary_kernel = without("/sys/kernel/realtime");
  const std::vector<Row> rows = {
      {"kernel", both(ordinary_kernel, with("/proc/version", kernel + "Debian 6.1.76-1")), kBad, "no preemption", "linux-image-rt-arm64"},
      {"kernel", both(ordinary_kernel, with("/proc/version", kernel + "PREEMPT Debian")), kCouldBeBetter, "PREEMPT",
       "linux-image-rt-arm64"},
      {"kernel", both(ordinary_kernel, with("/proc/version", kernel + "PREEMPT_DYNAMIC @0")), kCouldBeBetter, "PREEMPT_DYNAMIC", "reboot"},
      {"kernel", both(ordinary_kernel, with("/proc/version", kernel + "PREEMPT_RT @0")), kGood, "PREEMPT_RT", ""},
      {"kernel", both(with("/sys/kernel/realtime", "0"), with("/proc/version", kernel + "PREEMPT @0")), kCouldBeBetter, "PREEMPT",
       "reboot"},
      {"kernel", both(ordinary_kernel, with("/proc/version", "no kernel")), kNotRead, "no kernel", "cat /proc/version"},
      {"tick_priority", with("thread/tick/stat", stat("tick", 0, 0)), kBad, "ordinary", "rtprio"},
      {"tick_priority", with("thread/tick/stat", "(tick) S"), kNotRead, "", "where the controller runs"},
      {"xhci_priority", with("irq_thread/90/stat", stat("irq/51-xhci_hcd", 50, 1)), kCouldBeBetter,
       "51 BRCM STB PCIe MSI 524288 Edge xhci_h", "sudo chrt -f -p 76 90"},
      {"xhci_priority", with("irq_thread/90/stat", stat("irq/51-xhci_hcd", 75, 1)), kCouldBeBetter, "SCHED_FIFO 75", "chrt"},
      {"xhci_priority", with("irq_thread/90/stat", stat("irq/51-xhci_hcd", 0, 0)), kBad, "ordinary", "sudo chrt -f -p 76 90"},
      {"xhci_priority", with("irq_thread/92/stat", stat("irq/51-s-xhci_hcd", 50, 1)), kCouldBeBetter, "SCHED_FIFO 50",
       "sudo chrt -f -p 76 92"},
      {"xhci_priority", without("irq_thread/90/stat"), kGood, "no thread", ""},
      {"xhci_priority", with("irq_thread/90/stat", stat("irq/511-xhci_hcd", 1, 1)), kGood, "no thread", ""},
      {"xhci_priority", with("irq_thread/90/stat", "90 (irq/51-xhci_hcd) S"), kNotRead, "irq/51-xhci_hcd", "ps"},
      {"xhci_priority", with("kernel_thread", "bash"), kNotRead, "", "root"},
      {"xhci_priority", with("thread/exchange/stat", "x"), kNotRead, "", "controller"},
      {"xhci_priority", with("/proc/interrupts", "  CPU0\n 1: 5 GIC eth0\n"), kNotRead, "", "Falcon"},
      {"irq_affinity", with("/proc/irq/26/effective_affinity_list", "0-3"), kCouldBeBetter, "on core 3: 26 eth0",
       "for i in 26; do echo 0-2 | sudo tee /proc/irq/$i/smp_affinity_list; done"},
      {"irq_affinity", both(with("/proc/irq/26/effective_affinity_list", ""), with("/proc/irq/26/smp_affinity_list", "2-3")),
       kCouldBeBetter, "26 eth0", "for i in 26;"},
      {"irq_affinity", without("/proc/irq/26/effective_affinity_list"), kNotRead, "", "root"},
      {"irq_affinity", both(with("/proc/irq/11/effective_affinity_list", ""), with("/proc/irq/11/smp_affinity_list", "0-3")), kGood,
       "none on core 3", ""},
      {"irq_affinity", with("thread/tick/cores", "0-3"), kCouldBeBetter, "0-3", "[loop] core = 3"},
      {"irq_affinity", with("/sys/devices/system/cpu/online", "0"), kCouldBeBetter, "one core", "two or more cores"},
      {"isolated_cores", with("/sys/devices/system/cpu/isolated", ""), kCouldBeBetter, "none; the tick has 3",
       "isolcpus=managed_irq,domain,3"},
      {"isolated_cores", both(with("/sys/devices/system/cpu/isolated", "1-2"), with("grub", "")), kCouldBeBetter, "1-2; the tick has 3",
       "update-grub"},
      {"isolated_cores", with("thread/tick/cores", "0-3"), kCouldBeBetter, "the tick may run on 0-3", "[loop] core = 3"},
      {"isolated_cores", with("/sys/devices/system/cpu/online", "0"), kCouldBeBetter, "", "two or more cores"},
      {"rt_throttling", with("/proc/sys/kernel/sched_rt_runtime_us", "950000"), kCouldBeBetter, "950000 of 1000000 us",
       "sched_rt_runtime_us=-1"},
      {"rt_throttling", with("/proc/sys/kernel/sched_rt_runtime_us", "100000"), kBad, "100000", "sysctl"},
      {"rt_throttling", with("/proc/sys/kernel/sched_rt_runtime_us", "0"), kBad, "0 of", "sysctl"},
      {"governor", with(kCpu + "cpu2/cpufreq/scaling_governor", "schedutil"), kCouldBeBetter, "performance, schedutil",
       "echo performance | sudo tee"},
      {"governor", with(kCpu + "cpu2/cpufreq/scaling_governor", "powersave"), kBad, "powersave", "echo performance | sudo tee"},
      {"governor",
       both(with(kCpu + "cpu2/cpufreq/scaling_governor", "powersave"), with(kCpu + "cpu2/cpufreq/scaling_driver", "intel_pstate")),
       kCouldBeBetter, "powersave", "performance"},
      {"idle_states", with(kCpu + "cpu3/cpuidle/state1/time", "501"), kCouldBeBetter, "cpu-sleep, 90 us", "/dev/cpu_dma_latency"},
      {"idle_states", both(with(kCpu + "cpu3/cpuidle/state1/time", "501"), with(kCpu + "cpu3/cpuidle/state1/latency", "101")), kBad,
       "101 us", "active and hold"},
      {"idle_states", with(kCpu + "cpu1/cpuidle/state1/time", "501"), kGood, "WFI, 1 us", ""},
      {"idle_states", both(with(kCpu + "cpu1/cpuidle/state1/time", "501"), with("thread/tick/cores", "0-3")), kCouldBeBetter, "90 us",
       "active and hold"},
      {"idle_states", without(kCpu + "cpu3/cpuidle/state1/time"), kNotRead, "", "root"},
      {"idle_states", with("/sys/devices/system/cpu/cpuidle/current_driver", "haltpoll"), kNotRead, "", "host"},
      {"latency_file", with("/dev/cpu_dma_latency", "2000000000"), kCouldBeBetter, "held by nobody", "systemctl restart isotouchd"},
      {"latency_file", with("/dev/cpu_dma_latency", "50"), kCouldBeBetter, "held at 50 us", "systemctl"},
      {"usb_autosuspend", with(kFalcon + "power/control", "auto"), kCouldBeBetter, "auto",
       "echo on | sudo tee /sys/bus/usb/devices/1-1.2/power/control"},
      {"usb_autosuspend", both(with(kFalcon + "power/control", "auto"), with(kFalcon + "power/runtime_status", "suspended")), kBad,
       "suspended", "echo on"},
      {"usb_autosuspend", with(kFalcon + "idProduct", "6001"), kNotRead, "", "Connect the Falcon"},
      {"huge_pages", with("/sys/kernel/mm/transparent_hugepage/enabled", "[always] madvise never"), kCouldBeBetter, "always", "madvise"},
      {"huge_pages", with("/sys/kernel/mm/transparent_hugepage/enabled", "always madvise [never]"), kGood, "never", ""},
  };
  for (const Row& row : rows) {
    const Finding f = finding(row.key, row.spoil);
    EXPECT_EQ(f.verdict, row.verdict) << row.key << ": " << f.read << ": " << f.why;
    EXPECT_THAT(f.read, HasSubstr(row.read)) << row.key;
    EXPECT_THAT(f.remedy, HasSubstr(row.remedy)) << row.key;
    EXPECT_EQ(f.remedy.empty(), f.verdict == kGood) << row.key;
  }
}

/// Which finding depends on which files: a file that is not among them may hold anything.
const std::map<std::string, std::vector<std::string>> kNeeds = {
    {"kernel", {"/proc/version"}},
    {"tick_priority", {"thread/tick/stat"}},
    {"xhci_priority", {"/proc/interrupts", "kernel_thread"}},
    {"irq_affinity", {"/proc/interrupts", "thread/tick/cores", "/proc/irq/26/effective_affinity_list"}},
    {"isolated_cores", {"/sys/devices/system/cpu/isolated", "thread/tick/cores"}},
    {"rt_throttling", {"/proc/sys/kernel/sched_rt_runtime_us"}},
    {"governor", {kCpu + "cpu2/cpufreq/scaling_governor"}},
    {"idle_states", {kCpu + "cpu3/cpuidle/state0/time", kCpu + "cpu3/cpuidle/state1/latency", kCpu + "cpu3/cpuidle/state1/time"}},
    {"latency_file", {"/dev/cpu_dma_latency"}},
    {"usb_autosuspend", {kFalcon + "power/control"}},
    {"huge_pages", {"/sys/kernel/mm/transparent_hugepage/enabled"}},
};

TEST(Practice, WhatIsGarbledIsNeverGood) {
  const std::string garbage[] = {"",
                                 " ",
                                 "\x1b[2J\xff",
                                 "-",
                                 "-2",
                                 "99999999999999999999",
                                 "on off",
                                 "[",
                                 "][",
                                 "(",
                                 ")",
                                 std::string(100'000, '1'),
                                 std::string("\0", 1),
                                 "%s%n",
                                 "$(reboot)",
                                 "PREEMPT_R"};
  for (const auto& [key, paths] : kNeeds) {
    for (const std::string& path : paths) {
      for (const std::string& text : garbage) {
        const Finding f = finding(key, [&](BoardFiles& files) {
          files.texts[path] = text;
          files.texts.erase("/sys/kernel/realtime");
        });
        const bool is_list = text.find_first_not_of(" ") == std::string::npos && path.ends_with("isolated");
        EXPECT_NE(f.verdict, kGood) << key << ": " << path << ": '" << text.substr(0, 20) << "'";
        if (!is_list) {
          EXPECT_EQ(f.verdict, kNotRead) << key << ": " << path << ": '" << text.substr(0, 20) << "': " << f.why;
        }
        EXPECT_LT(f.read.size(), 400U) << key;
        EXPECT_EQ(f.read.find('\x1b'), std::string::npos) << key;
        EXPECT_EQ(f.remedy.find("reboot)"), std::string::npos) << key;
      }
    }
  }
}

TEST(Practice, WhateverABoardPrintsIsRead) {
  unsigned seed = 1;
  const auto next = [&] { return seed = seed * 1664525U + 1013904223U, seed >> 16; };
  std::string whole;
  for (const auto& [path, text] : good_files().texts) {
    for (const char c : path + ":" + text + "\n") whole += c;
  }
  for (int round = 0; round < 300; ++round) {
    std::string text = whole;
    for (int i = 0; i < 20; ++i) text[next() % text.size()] = static_cast<char>(next());
    text.resize(next() % text.size());
    const BoardFiles files = read_practice(text);
    for (const Finding& f : judge_practice(at_begin(), files, kWakeupUs)) EXPECT_FALSE(f.why.empty());
  }
}

TEST(Practice, EachVerdictHasAName) {
  EXPECT_STREQ(name_of(kGood), "good");
  EXPECT_STREQ(name_of(kCouldBeBetter), "could be better");
  EXPECT_STREQ(name_of(kBad), "bad");
  EXPECT_STREQ(name_of(kNotRead), "could not be read");
}

}  // namespace
}  // namespace isotouch::qualify
