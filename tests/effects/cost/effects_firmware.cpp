// What K5's firmware takes with and without each effect. `tests/measure effects-firmware` and a test run it; part.hpp
// has the words; beside them `linked`, the effects whose programs every check needs. The test also looks for symbols
// that K5 has with an effect alone in all other programs for boards.
#include <algorithm>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "../firmware_programs.hpp"
#include "firmware_symbols.hpp"
#include "k5.hpp"
#include "machines.hpp"
#include "memory_table.hpp"
#include "part.hpp"
#include "table_page.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;
namespace fs = std::filesystem;

constexpr const char* kSections[] = {".text", ".rodata", ".data", ".bss"};
/// What layout and alignment move in common code, in bytes and in instructions of a frame.
constexpr measured::Tolerance kFlashMore{.share = 0.01, .at_least = 16};
constexpr measured::Tolerance kInstructionsMore{.share = 0.01, .at_least = 100};

measured::Table format() {
  using measured::kExact, measured::kFlash, measured::kInstructions;
  return {.part = "effects-firmware",
          .columns = {{"effect"},
                      {"machine"},
                      {"text", kFlash},
                      {"text_more", kFlashMore},
                      {"rodata", kFlash},
                      {"rodata_more", kFlashMore},
                      {"data", kExact},
                      {"data_more", kExact},
                      {"bss", kExact},
                      {"bss_more", kExact},
                      {"instructions", kInstructions},
                      {"instructions_more", kInstructionsMore}}};
}

const Comparison& comparison_of(const std::string& effect) {
  return *std::ranges::find(kComparisons, effect, &Comparison::effect);
}

fs::path program_of(const fs::path& build, const std::string& machine, Effects effects) {
  return build / machine / ("k5_" + name_of(effects));
}

struct Drawn {
  std::string crc32;
  std::uint32_t arena = 0, instructions = 0;
};

Drawn drawn_by(const std::string& machine, const fs::path& program) {
  Drawn drawn;
  std::istringstream text(printed_on(machine, program, "k5"));
  if (!(text >> drawn.crc32 >> drawn.arena >> drawn.instructions)) {
    throw std::runtime_error(program.string() + " prints " + text.str());
  }
  return drawn;
}

std::vector<measured::Row> measure(const std::string& effect, const fs::path& build, const Names& machines) {
  const Comparison& comparison = comparison_of(effect);
  std::vector<measured::Row> rows;
  for (const std::string& machine : machines) {
    const fs::path with = program_of(build, machine, comparison.effects());
    const fs::path without = program_of(build, machine, comparison.without_it());
    const Drawn drawn_with = drawn_by(machine, with), drawn_without = drawn_by(machine, without);
    if ((drawn_with.crc32 == drawn_without.crc32) != comparison.draws_the_same) {
      throw std::runtime_error(effect + " on " + machine + ": K5 is drawn " +
                               (comparison.draws_the_same ? "otherwise with it" : "the same, which k5.hpp denies"));
    }
    measured::Row row{effect, machine};
    const auto add = [&](std::uint32_t less, std::uint32_t more) {
      row.push_back(std::to_string(less));
      row.push_back(std::to_string(std::int64_t{more} - std::int64_t{less}));
    };
    auto bytes_with = section_bytes(with), bytes_without = section_bytes(without);
    for (const char* section : kSections) add(bytes_without[section], bytes_with[section]);
    add(drawn_without.instructions, drawn_with.instructions);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What K5 has with the effect and not without; what K5 itself has is no other effect's own.
std::set<std::string> new_symbols(const Comparison& comparison, const fs::path& build) {
  const auto names = [&](Effects effects) { return symbol_names(program_of(build, kCheckedMachine, effects)); };
  const std::set<std::string> without = names(comparison.without_it()), k5 = names(kK5);
  std::set<std::string> result = names(comparison.effects());
  std::erase_if(result, [&](const std::string& name) {
    const bool is_of_compiler = name.starts_with("__");
    return is_of_compiler || without.contains(name) || (!kK5.has(comparison.added) && k5.contains(name));
  });
  return result;
}

const std::vector<effects_test::Program>& firmware() {
  static const auto programs = effects_test::firmware_programs(ZSTRIP_FIRMWARE_BINARIES);
  return programs;
}

/// The effects that programs for boards have: a symbol that is new with several effects may be there for any of them.
std::vector<Comparison> linked() {
  std::vector<Comparison> result;
  std::ranges::copy_if(kComparisons, std::back_inserter(result), [](const Comparison& comparison) {
    return std::ranges::any_of(firmware(), [&](const auto& program) { return program.effects.has(comparison.added); });
  });
  return result;
}

/// Symbols of the effect in programs whose scenes lack it; and that K5's own would be seen.
std::string check(const std::string& effect, const fs::path& build) {
  const Comparison& comparison = comparison_of(effect);
  effects_test::OwnSymbols own;
  for (const std::string& name : new_symbols(comparison, build)) {
    // K5 is not compared without vertex colours and with light, which needs it as well.
    own[name] = name == "shade_vertices" ? comparison.added | effect::lighting : comparison.added;
  }
  // Both are inlined into functions that are there anyway.
  const bool has_none = comparison.added == effect::lighting || comparison.added == effect::texture_alpha;
  std::string lines;
  if (own.empty() != has_none) lines += effect + (has_none ? " has" : " has no") + " symbols of its own\n";
  const effects_test::Program with{"k5_with", program_of(build, kCheckedMachine, comparison.effects()),
                                   comparison.without_it()};
  if (!has_none && misplaced(with, with.effects, own).empty()) lines += effect + ": its symbols are not seen in K5\n";
  for (const Comparison& other : linked()) {
    const std::set<std::string> shared = new_symbols(other, build);
    for (auto& [name, effects] : own) {
      if (shared.contains(name)) effects = effects | other.added;
    }
  }
  for (const effects_test::Program& program : firmware()) {
    const std::string found = misplaced(program, program.effects, own);
    if (!found.empty()) lines += program.name + " has symbols of " + effect + ", which its scene lacks:\n" + found;
  }
  return lines;
}

/// The names of effects that both programs have.
std::string beside(const Comparison& comparison) {
  std::string text;
  for (const Comparison& other : kComparisons) {
    if (comparison.beside == Effects{} || !comparison.beside.has(other.added)) continue;
    text += std::string(text.empty() ? "`" : ", `").append(other.effect) + "`";
  }
  return text;
}

std::string page(const measured::Table& table) {
  std::ostringstream text;
  text << "# The same firmware with and without each effect\n\nMeasured by `tests/measure effects-firmware`;\n"
          "[effects](../effects.md#the-same-firmware-with-and-without-it) says how, and\n"
          "[effects-firmware.csv](effects-firmware.csv) has the figures themselves. Bytes and instructions that the\n"
          "effect adds, on a Cortex-M0 / M3 / M4F.\n\n"
       << notes_of(table)
       << "\n| Effect | Beside | `.text` | `.rodata` | `.data` | `.bss` | Instructions a frame |\n"
          "|---|---|---|---|---|---|---|\n";
  for (const std::string& effect : effects_in(table)) {
    text << "| `" << effect << "` | " << beside(comparison_of(effect)) << " |";
    for (std::size_t column = 3; column < table.columns.size(); column += 2) {
      Names cells;
      for (const measured::Row& row : rows_of(table, effect)) cells.push_back(row[column]);
      text << ' ' << joined(cells) << " |";
    }
    text << '\n';
  }
  return text.str();
}

}  // namespace

int main(int count, char** words) {
  Part part{
      .format = format(),
      .notes = {budget::compiler_note()},
      .names = {},
      .usual = {"fog", "bins", "lines"},
      .programs =
          [](const std::string& effect) {
            const Comparison& comparison = comparison_of(effect);
            return std::set<std::string>{name_of(kK5), name_of(comparison.effects()), name_of(comparison.without_it())};
          },
      .measure = measure,
      .page = page,
      .check = check};
  for (const Comparison& comparison : kComparisons) part.names.emplace_back(comparison.effect);
  if (count == 2 && words[1] == std::string_view("linked")) {
    for (const Comparison& comparison : linked()) std::cout << comparison.effect << '\n';
    return 0;
  }
  return run_part(count, words, part);
}
