// The part of QEMU's interface for TCG plugins that the counting plugin uses, version 1, as QEMU's documentation "QEMU
// TCG Plugins" describes it. Debian does not package the header; the emulator refuses a plugin of another version.
#pragma once

#include <cstddef>
#include <cstdint>

// The names are QEMU's.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {

using qemu_plugin_id_t = std::uint64_t;
using qemu_plugin_meminfo_t = std::uint32_t;

struct qemu_info_t;
struct qemu_plugin_tb;    // a translated block
struct qemu_plugin_insn;  // an instruction of it

enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_CB_R_REGS, QEMU_PLUGIN_CB_RW_REGS };
enum qemu_plugin_mem_rw { QEMU_PLUGIN_MEM_R = 1, QEMU_PLUGIN_MEM_W, QEMU_PLUGIN_MEM_RW };

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, void (*cb)(qemu_plugin_id_t, qemu_plugin_tb*));
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb* tb, void (*cb)(unsigned vcpu, void* userdata),
                                          qemu_plugin_cb_flags flags, void* userdata);
void qemu_plugin_register_vcpu_mem_cb(qemu_plugin_insn* insn,
                                      void (*cb)(unsigned vcpu, qemu_plugin_meminfo_t info, std::uint64_t vaddr,
                                                 void* userdata),
                                      qemu_plugin_cb_flags flags, qemu_plugin_mem_rw rw, void* userdata);
/// Returns true if the memory access writes.
bool qemu_plugin_mem_is_store(qemu_plugin_meminfo_t info);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, void (*cb)(qemu_plugin_id_t, void*), void* userdata);

std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* tb);
std::uint64_t qemu_plugin_tb_vaddr(const qemu_plugin_tb* tb);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* tb, std::size_t index);
std::uint64_t qemu_plugin_insn_vaddr(const qemu_plugin_insn* insn);
/// Returns the instruction's bytes in memory.
const void* qemu_plugin_insn_data(const qemu_plugin_insn* insn);
/// Returns the disassembled text; the caller frees it.
char* qemu_plugin_insn_disas(const qemu_plugin_insn* insn);

// The symbols that the emulator looks for in a plugin.
[[gnu::visibility("default")]] extern int qemu_plugin_version;
[[gnu::visibility("default")]] int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info, int count,
                                                       char** arguments);
}
// NOLINTEND(readability-identifier-naming)
