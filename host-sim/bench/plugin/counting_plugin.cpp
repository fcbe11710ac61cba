// A QEMU plugin that counts what a program executes between two functions, region by region: how often each block of
// instructions ran, how often it left by a taken branch, and how often a flash cache of given size would have missed.
//
//   -plugin PLUGIN,out=FILE,resume=ADDRESS:BYTES,pause=ADDRESS:BYTES,ram=ADDRESS,
//           code=LINES:WAYS:BYTES,data=LINES:WAYS:BYTES
//
// A region begins when the function at `resume` is entered and ends when that at `pause` is; the instructions of these
// two are not counted. Below `ram` is flash. With data=shared data go through the cache of the code. FILE gets lines:
//   i ADDRESS BYTES TEXT                    an instruction, disassembled
//   b NUMBER ADDRESS COUNT                  a block: as many instructions from there on
//   x NUMBER EXECUTIONS TAKEN               in the region that is about to end
//   r JUMPS SEQUENTIAL READS READ_MISSES    end of a region that executed something: lines of code that missed after a
//                                           jump, and after the line before; data reads from flash, and their misses
// Addresses are hexadecimal without a prefix, counts decimal. Single-threaded, as -icount makes the emulator.
#include <charconv>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "flash_cache.hpp"
#include "qemu_plugin.hpp"

int qemu_plugin_version = 1;

namespace {

using zstrip::sim::FlashCache;

struct Function {
  std::uint32_t begin = 0, end = 0;
  bool holds(std::uint32_t address) const { return address >= begin && address < end; }
};

struct Block {
  std::uint32_t number, begin, end;
  std::uint64_t executions = 0, taken = 0;  // in this region
};

struct Counts {
  std::uint64_t jumps = 0, sequential = 0, reads = 0, read_misses = 0;
};

struct Plugin {
  std::FILE* out = nullptr;
  Function resume, pause;
  std::uint32_t ram = 0;
  std::optional<FlashCache> code, data;  // without data they share

  std::deque<Block> blocks;  // a block keeps its address for ever: the emulator holds it
  std::unordered_set<std::uint32_t> described;
  bool counting = false;
  Block* previous = nullptr;
  std::uint32_t previous_line = 0;
  std::vector<Block*> executed;
  Counts counts;
};
Plugin plugin;

void fetch(const Block& block) {
  if (block.begin >= plugin.ram) return;
  const std::uint32_t last = plugin.code->line_of(block.end - 1);
  for (std::uint32_t line = plugin.code->line_of(block.begin); line <= last; ++line) {
    if (line == plugin.previous_line) continue;
    if (!plugin.code->touch(line)) {
      ++(line == plugin.previous_line + 1 ? plugin.counts.sequential : plugin.counts.jumps);
    }
    plugin.previous_line = line;
  }
}

void end_region() {
  if (!plugin.executed.empty()) {
    if (plugin.previous != nullptr) ++plugin.previous->taken;  // the call that ends the region
    for (Block* block : plugin.executed) {
      std::fprintf(plugin.out, "x %" PRIu32 " %" PRIu64 " %" PRIu64 "\n", block->number, block->executions,
                   block->taken);
      block->executions = block->taken = 0;
    }
    const Counts& c = plugin.counts;
    std::fprintf(plugin.out, "r %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", c.jumps, c.sequential, c.reads,
                 c.read_misses);
  }
  plugin.executed.clear();
  plugin.counts = {};
}

void on_execution(unsigned /*vcpu*/, void* userdata) {
  auto& block = *static_cast<Block*>(userdata);
  if (plugin.resume.holds(block.begin)) {
    plugin.counting = true;
    plugin.previous = nullptr;
    return;
  }
  if (!plugin.counting) return;
  if (plugin.pause.holds(block.begin)) {
    end_region();
    plugin.counting = false;
    return;
  }
  if (plugin.previous != nullptr && plugin.previous->end != block.begin) ++plugin.previous->taken;
  plugin.previous = &block;
  if (block.executions++ == 0) plugin.executed.push_back(&block);
  fetch(block);
}

void on_access(unsigned /*vcpu*/, qemu_plugin_meminfo_t info, std::uint64_t address, void* /*userdata*/) {
  if (!plugin.counting || address >= plugin.ram || qemu_plugin_mem_is_store(info)) return;
  ++plugin.counts.reads;
  FlashCache& cache = plugin.data ? *plugin.data : *plugin.code;
  if (!cache.touch(cache.line_of(static_cast<std::uint32_t>(address)))) ++plugin.counts.read_misses;
}

/// qemu_plugin_insn_size() counts the fetched bytes, which at the end of a page are more than the instruction.
std::uint32_t thumb_bytes(const qemu_plugin_insn* instruction) {
  const auto* const bytes = static_cast<const std::uint8_t*>(qemu_plugin_insn_data(instruction));
  constexpr std::uint8_t kFirstOfFour = 0xE8;  // the upper byte of the first half-word, from here on
  return bytes[1] >= kFirstOfFour ? 4 : 2;
}

void on_translation(qemu_plugin_id_t /*id*/, qemu_plugin_tb* tb) {
  const std::size_t count = qemu_plugin_tb_n_insns(tb);
  const auto begin = static_cast<std::uint32_t>(qemu_plugin_tb_vaddr(tb));
  std::uint32_t end = begin;
  for (std::size_t i = 0; i < count; ++i) {
    qemu_plugin_insn* const instruction = qemu_plugin_tb_get_insn(tb, i);
    const auto address = static_cast<std::uint32_t>(qemu_plugin_insn_vaddr(instruction));
    const std::uint32_t bytes = thumb_bytes(instruction);
    end = address + bytes;
    if (plugin.described.insert(address).second) {
      char* const text = qemu_plugin_insn_disas(instruction);
      std::fprintf(plugin.out, "i %" PRIx32 " %" PRIu32 " %s\n", address, bytes, text);
      std::free(text);
    }
    // Both: QEMU 7.2 exchanges the two.
    qemu_plugin_register_vcpu_mem_cb(instruction, on_access, QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_RW, nullptr);
  }
  const auto number = static_cast<std::uint32_t>(plugin.blocks.size());
  plugin.blocks.push_back({number, begin, end});
  std::fprintf(plugin.out, "b %" PRIu32 " %" PRIx32 " %zu\n", number, begin, count);
  qemu_plugin_register_vcpu_tb_exec_cb(tb, on_execution, QEMU_PLUGIN_CB_NO_REGS, &plugin.blocks.back());
}

void on_exit(qemu_plugin_id_t /*id*/, void* /*userdata*/) { std::fclose(plugin.out); }

/// Returns numbers separated by colons; empty if there is other text between them.
std::vector<std::uint32_t> numbers(std::string_view text, int base) {
  std::vector<std::uint32_t> values;
  while (true) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc{}) return {};
    values.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return values;
    if (text.front() != ':') return {};
    text.remove_prefix(1);
  }
}

bool set_function(Function& function, std::string_view value) {
  const std::vector<std::uint32_t> words = numbers(value, 16);
  if (words.size() != 2) return false;
  function = {words[0], words[0] + words[1]};
  return true;
}

bool set_cache(std::optional<FlashCache>& cache, std::string_view value) {
  const std::vector<std::uint32_t> words = numbers(value, 10);
  if (words.size() != 3 || words[1] == 0 || words[0] % words[1] != 0 || words[2] == 0) return false;
  cache.emplace(words[0], words[1], words[2]);
  return true;
}

bool set_ram(std::string_view value) {
  const std::vector<std::uint32_t> words = numbers(value, 16);
  if (words.size() != 1) return false;
  plugin.ram = words[0];
  return true;
}

bool set(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string_view::npos) return false;
  const std::string_view key = argument.substr(0, equals), value = argument.substr(equals + 1);
  if (key == "resume") return set_function(plugin.resume, value);
  if (key == "pause") return set_function(plugin.pause, value);
  if (key == "ram") return set_ram(value);
  if (key == "code") return set_cache(plugin.code, value);
  if (key == "data") return value == "shared" || set_cache(plugin.data, value);
  if (key == "out") return (plugin.out = std::fopen(std::string(value).c_str(), "w")) != nullptr;
  return false;
}

}  // namespace

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* /*info*/, int count, char** arguments) {
  for (int i = 0; i < count; ++i) {
    if (!set(arguments[i])) {
      std::fprintf(stderr, "counting plugin: cannot use '%s'\n", arguments[i]);
      return 1;
    }
  }
  if (plugin.out == nullptr || !plugin.code || plugin.resume.end == 0 || plugin.pause.end == 0) {
    std::fprintf(stderr, "counting plugin: needs out, resume, pause and code\n");
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  qemu_plugin_register_atexit_cb(id, on_exit, nullptr);
  return 0;
}
