/// Counts the instructions of each tick, stage by stage: a plugin for QEMU, for programs and for whole machines, on every processor alike.
///
///     qemu-aarch64 -plugin libstage_counter.so,map=MAP,rows=ROWS -d plugin PROGRAM ...
///
/// MAP has a line for each function that matters: its address and size in the program's file, in hexadecimal, and a word:
///
///     code                where the program's first executable segment begins, so that one that was loaded elsewhere is found
///     tick                the tick begins with this function's first instruction
///     outside             the tick has ended when this function runs: it is who calls the tick
///     0, 1, 2, ...        the stage that the function belongs to
///
/// What stands in no line, as memset, belongs to the stage that called it. ROWS gets a line for each tick: the instructions of every stage.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "hil/instructions/qemu_plugin.h"

extern "C" __attribute__((visibility("default"))) int qemu_plugin_version;
extern "C" __attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t, const qemu_info_t*, int, char**);
int qemu_plugin_version = qemu_plugin_num_vcpus == nullptr ? 1 : 2;

namespace {

constexpr int kOutside = -1, kAnyStage = -2;

struct Function {
  std::uint64_t end = 0;
  int stage = kAnyStage;
};

/// Straight code, as far as it matters.
struct Block {
  std::uint64_t instructions;
  int stage;
  bool begins_tick;
};

class StageCounter {
 public:
  bool read(const char* map) {
    std::FILE* file = std::fopen(map, "r");
    if (file == nullptr) return false;
    unsigned long long begin = 0, size = 0;
    char word[16];
    while (std::fscanf(file, "%llx %llx %15s", &begin, &size, word) == 3) {
      const std::string what = word;
      if (what == "code") {
        code_ = begin;
      } else if (what == "tick") {
        ticks_.push_back(begin);
      } else {
        const int stage = what == "outside" ? kOutside : std::stoi(what);
        functions_[begin] = {begin + size, stage};
        stages_ = std::max(stages_, static_cast<std::size_t>(stage + 1));
      }
    }
    const bool whole = std::feof(file) != 0;
    std::fclose(file);
    now_.resize(stages_);
    return whole && stages_ > 0 && !ticks_.empty();
  }
  bool write_to(const char* rows) { return (rows_ = std::fopen(rows, "w")) != nullptr; }
  void finish() { std::fclose(rows_); }

  /// Blocks live as long as the machine does.
  Block* block(std::uint64_t address, std::size_t instructions) {
    const std::uint64_t loaded = qemu_plugin_start_code();
    const std::uint64_t at = loaded == 0 ? address : address - loaded + code_;
    Block block{instructions, kAnyStage, std::find(ticks_.begin(), ticks_.end(), at) != ticks_.end()};
    if (const auto next = functions_.upper_bound(at); next != functions_.begin()) {
      if (const Function& function = std::prev(next)->second; at < function.end) block.stage = function.stage;
    }
    return &blocks_.emplace_back(block);
  }

  void run(const Block& block) {
    if (!in_tick_ && !block.begins_tick) return;
    if (block.stage == kOutside) return end_tick();
    in_tick_ = true;
    if (block.stage != kAnyStage) stage_ = static_cast<std::size_t>(block.stage);
    now_[stage_] += block.instructions;
  }

 private:
  void end_tick() {
    for (std::size_t stage = 0; stage < stages_; ++stage) {
      std::fprintf(rows_, "%llu%c", static_cast<unsigned long long>(now_[stage]), stage + 1 < stages_ ? ' ' : '\n');
    }
    std::fill(now_.begin(), now_.end(), 0);
    in_tick_ = false;
  }

  std::uint64_t code_ = 0;
  std::vector<std::uint64_t> ticks_;
  std::map<std::uint64_t, Function> functions_;
  std::deque<Block> blocks_;
  std::size_t stages_ = 0, stage_ = 0;
  std::vector<std::uint64_t> now_;
  bool in_tick_ = false;
  std::FILE* rows_ = nullptr;
};

StageCounter& counter() {
  static StageCounter the_one;
  return the_one;
}

void on_run(unsigned, void* block) { counter().run(*static_cast<const Block*>(block)); }

void on_translated(qemu_plugin_id_t, qemu_plugin_tb* tb) {
  Block* block = counter().block(qemu_plugin_tb_vaddr(tb), qemu_plugin_tb_n_insns(tb));
  qemu_plugin_register_vcpu_tb_exec_cb(tb, on_run, QEMU_PLUGIN_CB_NO_REGS, block);
}

void on_end(qemu_plugin_id_t, void*) { counter().finish(); }

}  // namespace

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t*, int argc, char** argv) {
  std::string map, rows;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("map=", 0) == 0) map = argument.substr(4);
    if (argument.rfind("rows=", 0) == 0) rows = argument.substr(5);
  }
  if (!counter().read(map.c_str())) {
    std::fprintf(stderr, "stage_counter: %s: no map of functions, or a line of it that is none\n", map.c_str());
    return 1;
  }
  if (!counter().write_to(rows.c_str())) {
    std::fprintf(stderr, "stage_counter: %s: cannot be written\n", rows.c_str());
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translated);
  qemu_plugin_register_atexit_cb(id, on_end, nullptr);
  return 0;
}
