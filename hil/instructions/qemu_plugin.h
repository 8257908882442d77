/// What QEMU offers a plugin, as far as it is used here. Debian ships no header; version 1 of the interface, QEMU 4.2 and later.
///
/// source    QEMU, docs/devel/tcg-plugins.rst
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

using qemu_plugin_id_t = std::uint64_t;
struct qemu_info_t;
struct qemu_plugin_tb;    // a block of instructions without a branch, translated at once
struct qemu_plugin_insn;  // one of them
enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };

using BlockTranslated = void (*)(qemu_plugin_id_t, qemu_plugin_tb*);
using BlockRuns = void (*)(unsigned processor, void* user);
using MachineEnds = void (*)(qemu_plugin_id_t, void* user);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, BlockTranslated);
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb*, BlockRuns, qemu_plugin_cb_flags, void* user);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, MachineEnds, void* user);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb*);
std::uint64_t qemu_plugin_tb_vaddr(const qemu_plugin_tb*);
std::uint64_t qemu_plugin_start_code();  // where a program's code was loaded; 0 for a whole machine

}  // extern "C"
