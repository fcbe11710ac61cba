// A QEMU plugin that prints, at the end of a program, how many instructions it has executed.
#include <cstdint>
#include <cstdio>

#include "bench/plugin/qemu_plugin.hpp"

int qemu_plugin_version = 1;

namespace {

std::uint64_t total;

void on_execution(unsigned /*vcpu*/, void* count) { total += reinterpret_cast<std::uintptr_t>(count); }

void on_translation(qemu_plugin_id_t /*id*/, qemu_plugin_tb* tb) {
  // The callback's own word is the number: no memory to keep for each block.
  auto* const count = reinterpret_cast<void*>(qemu_plugin_tb_n_insns(tb));  // NOLINT(performance-no-int-to-ptr)
  qemu_plugin_register_vcpu_tb_exec_cb(tb, on_execution, QEMU_PLUGIN_CB_NO_REGS, count);
}

void on_exit(qemu_plugin_id_t /*id*/, void* /*userdata*/) {
  std::fprintf(stderr, "%llu\n", static_cast<unsigned long long>(total));  // QEMU ends without a flush
}

}  // namespace

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* /*info*/, int /*count*/, char** /*arguments*/) {
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  qemu_plugin_register_atexit_cb(id, on_exit, nullptr);
  return 0;
}
