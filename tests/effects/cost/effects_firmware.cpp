// What K5's firmware takes with and without each effect. `tests/measure effects-firmware` and a test run it; part.hpp
// has the words.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "elf_file.hpp"
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

std::map<std::string, std::uint32_t> section_bytes(const fs::path& program) {
  std::map<std::string, std::uint32_t> bytes;
  for (const budget::Section& section : budget::read_elf(program).sections) bytes[section.name] += section.size;
  return bytes;
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
      .check = {}};
  for (const Comparison& comparison : kComparisons) part.names.emplace_back(comparison.effect);
  return run_part(count, words, part);
}
