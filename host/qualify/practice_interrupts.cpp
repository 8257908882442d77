#include "host/qualify/practice_interrupts.h"

#include <algorithm>
#include <regex>

namespace isotouch::qualify {

namespace {

constexpr const char* kInterrupts = "/proc/interrupts";

bool is_usb(const Interrupt& interrupt) {
  static const std::regex kUsb("(xhci|ehci|ohci|uhci|dwc2|dwc3|dwc_otg|musb|ci_hdrc|usb)", std::regex::icase);
  return std::regex_search(shown(interrupt.name), kUsb);
}

/// One that every processor has for itself, such as its timer: nobody can move it.
bool is_of_a_processor(const Interrupt& interrupt) {
  static const std::regex kOwn("(timer|pmu)", std::regex::icase);
  return std::regex_search(shown(interrupt.name), kOwn);
}

/// A thread that serves an interrupt.
struct Server {
  std::string pid, stat;
  std::optional<Scheduling> scheduling;

  int priority() const { return scheduling ? scheduling->priority : -1; }
};

/// Of the interrupt of this number; of several the least important, and before it one that cannot be read.
std::optional<Server> server_of(const Board& board, int number) {
  const std::string begin = "irq_thread/", end = "/stat", name = "irq/" + std::to_string(number) + "-";
  std::optional<Server> least;
  for (const auto& [path, stat] : board.under(begin, end)) {
    const Server server{path.substr(begin.size(), path.size() - begin.size() - end.size()), stat, scheduling(stat)};
    if (!name_in(stat).starts_with(name) || !whole_number(server.pid)) continue;
    if (!least || server.priority() < least->priority()) least = server;
  }
  return least;
}

}  // namespace

Finding xhci_priority(const Board& board) {
  const Ask ask{"xhci_priority", "priority of the USB interrupt"};
  const std::string* text = board.text(kInterrupts);
  if (text == nullptr) return ask.not_read(board, kInterrupts);
  std::vector<Interrupt> usb = interrupts(*text);
  std::erase_if(usb, [](const Interrupt& one) { return !is_usb(one); });
  if (usb.empty())
    return ask.not_known("No USB controller has an interrupt on this machine.", "Connect the Falcon to a board that has one.");
  const std::string* second = board.text("kernel_thread");
  if (second == nullptr || *second != "kthreadd")
    return ask.not_known("This user may not see the kernel's threads.", "Measure as a user who may, such as root: --to ssh://root@board");

  const auto exchange = board.thread("exchange");
  const int ours = exchange && exchange->is_real_time() ? exchange->priority : 0;
  std::optional<Server> least;
  std::string read;
  for (const Interrupt& one : usb) {
    const auto server = server_of(board, one.number);
    if (server && !server->scheduling) return ask.garbled(server->stat, "See it with: ps -o pid,cls,rtprio,comm -p " + server->pid);
    read += (read.empty() ? "" : "; ") + std::to_string(one.number) + " " + shown(one.name, 40) + ": " +
            (!server                              ? "no thread"
             : server->scheduling->is_real_time() ? server->scheduling->text()
                                                  : "ordinary scheduling");
    if (server && (!least || server->priority() < least->priority())) least = server;
  }
  if (!least) return ask.good(read, "This kernel serves the interrupt at once, before every thread.");
  const std::string remedy =
      "Run: sudo chrt -f -p " + std::to_string(std::min(ours + 1, 99)) + " " + least->pid + " (again after each start of the machine)";
  if (!least->scheduling->is_real_time()) return ask.bad(read, "Any program can hold up what the device answers.", remedy);
  if (!exchange) return ask.no_controller(read);
  if (least->priority() > ours) return ask.good(read, "The kernel takes the device's answer before the thread that waits for it runs.");
  return ask.better(read,
                    "Other interrupts and the controller's own threads, at priority " + std::to_string(ours) +
                        " and above, may hold up what the device answers.",
                    remedy);
}

Finding irq_affinity(const Board& board) {
  const Ask ask{"irq_affinity", "interrupts on the tick's core"};
  const std::string* text = board.text(kInterrupts);
  if (text == nullptr) return ask.not_read(board, kInterrupts);
  const auto tick = board.cores("tick");
  if (!tick) return ask.no_controller();
  const auto online = board.online();
  if (online && online->size() == 1)
    return ask.better("one core", "Every interrupt comes on the only core, the tick's.", "Use a board with two or more cores.");
  if (tick->size() != 1)
    return ask.better(
        "the tick may run on " + list_of(*tick), "The tick is not bound to a core, so interrupts cannot be kept off it.",
        "Set [loop] core = " + std::to_string(board.best_core()) + " in the settings, then: sudo systemctl restart isotouchd");
  const std::vector<Interrupt> all = interrupts(*text);
  if (all.empty()) return ask.garbled_file(kInterrupts, *text);
  std::string numbers, names;
  bool unread = false;
  for (const Interrupt& one : all) {
    if (!one.has_come() || is_of_a_processor(one)) continue;
    const std::string folder = "/proc/irq/" + std::to_string(one.number);
    const std::string* effective = board.text(folder + "/effective_affinity_list");
    const std::string* list = effective != nullptr && !shown(*effective).empty() ? effective : board.text(folder + "/smp_affinity_list");
    const auto cores = list == nullptr ? std::nullopt : processors(*list);
    if (!cores || cores->empty()) unread = true;
    if (!cores || cores->count(*tick->begin()) == 0) continue;
    numbers += (numbers.empty() ? "" : " ") + std::to_string(one.number);
    names += (names.empty() ? "" : ", ") + std::to_string(one.number) + " " + shown(one.name.substr(one.name.rfind(' ') + 1), 24);
  }
  const std::string core = list_of(*tick);
  if (numbers.empty() && unread) return ask.not_read(board, "/proc/irq");
  if (numbers.empty()) return ask.good("none on core " + core, "No device interrupts the tick.");
  std::set<int> others = online.value_or(std::set<int>{});
  others.erase(*tick->begin());
  return ask.better(
      "on core " + core + ": " + shown(names, 120), "These devices interrupt the tick.",
      "Run: for i in " + numbers + "; do echo " + (others.empty() ? "0" : list_of(others)) +
          " | sudo tee /proc/irq/$i/smp_affinity_list; done (stop irqbalance first, and do it again after each start of the machine)");
}

}  // namespace isotouch::qualify
