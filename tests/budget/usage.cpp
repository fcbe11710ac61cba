// Puts together what sections, symbols, call graph, plan and emulator say of a program.
#include "usage.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "board_run.hpp"
#include "call_graph.hpp"
#include "elf_file.hpp"
#include "reader_name.hpp"
#include "tool_output.hpp"
#include "zstrip_scenes/scenes.hpp"
#include "zstrip_scenes/showroom.hpp"

namespace zstrip::budget {
namespace {

std::string disassembly_of(const std::filesystem::path& program) {
  return output_of("arm-none-eabi-objdump -d --no-show-raw-insn '" + program.string() + "'");
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Of the object files that the program is linked from.
CompilerFrames compiler_frames(const std::filesystem::path& program) {
  CompilerFrames frames;
  std::ifstream list(std::filesystem::path(program).replace_extension(".objects"));
  for (std::string object; std::getline(list, object);) {
    if (!object.empty()) add_compiler_frames(frames, contents(std::filesystem::path(object).replace_extension(".ci")));
  }
  if (frames.empty()) throw std::runtime_error(program.string() + ": the compiler has stated no frames");
  return frames;
}

/// Bytes of the variables of this name, in whatever namespace or class.
std::uint32_t variable_bytes(const ElfFile& elf, const std::string& name) {
  std::uint32_t bytes = 0;
  for (const Symbol& symbol : elf.symbols) {
    if (symbol.name.find(name) == std::string::npos) continue;
    const std::string full = demangled(symbol.name);
    if (!symbol.is_function && (full == name || full.ends_with("::" + name))) bytes += symbol.size;
  }
  return bytes;
}

const Section& section(const ElfFile& elf, const std::string& name) {
  for (const Section& each : elf.sections) {
    if (each.name == name) return each;
  }
  throw std::runtime_error("there is no section " + name);
}

void measure_stack(Usage& usage, const ElfFile& elf, const std::filesystem::path& program) {
  const CallGraph graph(disassembly_of(program), elf, compiler_frames(program));
  usage.stack_bound = graph.bound_of("reset_handler").bytes;
  usage.stack_reserved = elf.size_of(".stack");
  const std::uint32_t fault_bound = graph.bound_of("report_fault").bytes;
  const std::uint32_t fault_stack = variable_bytes(elf, "fault_stack");
  if (fault_bound > fault_stack) {
    throw std::runtime_error("the report of a fault takes " + std::to_string(fault_bound) + " bytes of its stack of " +
                             std::to_string(fault_stack));
  }
}

/// What a plan needs to know of the target's scene.
SceneCounts counts_of(const Target& target) {
  if (const scenes::BuiltIn* const scene = scenes::find(target.scene)) return scene->counts;
  return count(scenes::kShowroomBackground);  // whose plan takes more of the arena than that of what moves
}

/// The plan of an arena of this size; whoever sized it had the same planner. 0: the size is not known.
Plan plan_of(const Target& target, const BoardRun& run, std::uint32_t arena) {
  Budget budget{.bytes = arena, .strip_rows = target.strip_rows, .strip_columns = target.strip_columns};
  if (run.strip_rows != 0) {
    budget = {.strip_rows = static_cast<std::uint16_t>(run.strip_rows),
              .strip_columns = static_cast<std::uint16_t>(run.strip_columns)};
  }
  if (target.binned) budget.modes = Modes::binned;
  const Effects effects = effects_of(target) | (target.binned ? effect::bins : Effects{});
  const PlanResult result = plan(counts_of(target), target.view, effects, budget);
  if (!result.status || (arena != 0 && result.plan.bytes() != arena)) {
    throw std::runtime_error("the board's arena has " + std::to_string(arena) + " bytes, the host plans " +
                             std::to_string(result.plan.bytes()));
  }
  return result.plan;
}

/// The plan of a program whose arena is a part of its FixedRenderer.
Plan fixed_plan(const Target& target, const BoardRun& run, const ElfFile& elf) {
  const Plan plan = plan_of(target, run, 0);
  const std::uint32_t renderer = variable_bytes(elf, "renderer");
  constexpr std::uint32_t kMostState = 512;  // beside the arena
  if (renderer < plan.bytes() || renderer > plan.bytes() + kMostState) {
    throw std::runtime_error("the board's renderer has " + std::to_string(renderer) +
                             " bytes with its arena, for which the host plans " + std::to_string(plan.bytes()));
  }
  return plan;
}

}  // namespace

Usage measure(const Target& target, const std::filesystem::path& binaries) {
  const std::filesystem::path program = file_of(target, binaries);
  const ElfFile elf = read_elf(program);
  Usage usage{.target = &target};
  usage.code = elf.size_of(".text");
  usage.constants = elf.size_of(".rodata");
  usage.initial_data = elf.size_of(".data");
  const BoardRun run = run_on_board(target, program, section(elf, ".stack"));
  usage.stack_measured = run.stack;
  std::uint32_t lent = 0;
  if (target.report == Report::bench) {
    lent = variable_bytes(elf, "memory");  // for whatever the words ask for
    usage.pixels = run.pixels;
    usage.plan = plan_of(target, run, run.arena);
  } else {
    const std::uint32_t arena = variable_bytes(elf, "arena");
    usage.pixels = variable_bytes(elf, "pixels");
    usage.plan = arena != 0 ? plan_of(target, run, arena) : fixed_plan(target, run, elf);
    lent = usage.plan.bytes() + usage.pixels;
  }
  usage.arena = usage.plan.bytes();
  if (run.arena != 0 && (run.arena != usage.arena || run.pixels != usage.pixels)) {
    throw std::runtime_error("the program reports another arena or strip than it has variables for");
  }
  usage.statics = elf.size_of(".data") + elf.size_of(".bss") - lent;
  measure_stack(usage, elf, program);
  return usage;
}

std::vector<SymbolSize> symbol_sizes(const std::filesystem::path& program) {
  const ElfFile elf = read_elf(program);
  const auto in_ram = [&](const Symbol& symbol) {
    for (const char* name : {".data", ".bss"}) {
      const Section& variables = section(elf, name);
      if (symbol.address >= variables.address && symbol.address - variables.address < variables.size) return true;
    }
    return false;
  };
  std::map<std::pair<bool, std::string>, std::uint32_t> bytes;
  std::optional<std::uint32_t> last;  // several names of one address count once
  for (const Symbol& symbol : elf.symbols) {
    if (symbol.address != last) bytes[{in_ram(symbol), without_arguments(reader_name(symbol.name))}] += symbol.size;
    last = symbol.address;
  }
  std::vector<SymbolSize> sizes;
  for (const auto& [key, size] : bytes) sizes.push_back({key.second, size, key.first});
  std::stable_sort(sizes.begin(), sizes.end(), [](const SymbolSize& a, const SymbolSize& b) {
    return a.in_ram != b.in_ram ? b.in_ram : a.bytes > b.bytes;
  });
  return sizes;
}

}  // namespace zstrip::budget
