/// What QEMU offers a plugin, as far as it is used here. Debian ships no header. Versions 1 and 2 of the interface, QEMU 4.2 and 9.0 and later, which differ in
/// nothing that is used, but a QEMU of one of them refuses a plugin of the other.
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

__attribute__((weak)) int qemu_plugin_num_vcpus();  // has come with version 2

}  // extern "C"
