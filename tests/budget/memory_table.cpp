// Columns and rows of the table, and what goes with it in messages.
#include "memory_table.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

namespace zstrip::budget {
namespace {

using measured::kExact;
using measured::kFlash;

constexpr std::size_t kSymbolsOfFlash = 12, kSymbolsOfRam = 6;

}  // namespace

measured::Table memory_format() {
  return {.part = "memory",
          .columns = {{"program"},
                      {"scene"},
                      {"code", kFlash},
                      {"constants", kFlash},
                      {"initial_data", kFlash},
                      {"strips", kExact},
                      {"instances", kExact},
                      {"extents", kExact},
                      {"vertices", kExact},
                      {"depth", kExact},
                      {"colour", kExact},
                      {"bins", kExact},
                      {"arena", kExact},
                      {"pixels", kExact},
                      {"statics", kExact},
                      {"stack_reserved", kExact},
                      {"stack_bound", kExact},
                      {"stack_measured", kExact}}};
}

measured::Row row_of(const Usage& usage) {
  const Plan& plan = usage.plan;
  measured::Row row{usage.target->program, usage.target->scene};
  for (const std::uint32_t bytes : {usage.code, usage.constants, usage.initial_data})
    row.push_back(std::to_string(bytes));
  row.push_back(std::to_string(plan.strips) + " of " + std::to_string(plan.strip_columns) + "x" +
                std::to_string(plan.strip_rows));
  for (const std::uint32_t bytes :
       {plan.instance_bytes, plan.extent_bytes, plan.vertex_bytes, plan.depth_bytes, plan.colour_bytes, plan.bin_bytes,
        usage.arena, usage.pixels, usage.statics, usage.stack_reserved, usage.stack_bound}) {
    row.push_back(std::to_string(bytes));
  }
  row.push_back(usage.target->report == Report::none ? "" : std::to_string(usage.stack_measured));
  return row;
}

std::string compiler_note(const std::string& options) {
  constexpr const char* kCompiler = "arm-none-eabi-g++";
  FILE* const pipe = popen((std::string(kCompiler) + " -dumpfullversion").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(std::string("cannot run ") + kCompiler);
  std::array<char, 64> buffer{};
  const std::size_t count = std::fread(buffer.data(), 1, buffer.size() - 1, pipe);
  if (pclose(pipe) != 0) throw std::runtime_error(std::string("failed: ") + kCompiler);
  const std::string version(buffer.data(), count);
  return std::string("compiled by ") + kCompiler + " " + version.substr(0, version.find('\n')) + " with " + options;
}

std::string largest_symbols(const std::filesystem::path& program) {
  std::string text;
  std::size_t named[2] = {};
  for (const SymbolSize& symbol : symbol_sizes(program)) {
    if (named[symbol.in_ram]++ >= (symbol.in_ram ? kSymbolsOfRam : kSymbolsOfFlash)) continue;
    text += std::string("  ") + (symbol.in_ram ? "RAM" : "flash") + ", " + std::to_string(symbol.bytes) +
            " bytes: " + symbol.name + '\n';
  }
  return text;
}

}  // namespace zstrip::budget
