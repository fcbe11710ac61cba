// Compares the programs of k5.hpp:
//   flash_table programs [EFFECT...]                       prints BITS_METHODS of the programs that these comparisons
//   need flash_table write BUILD PAGE ROWS [EFFECT...]          measures them and rewrites the page's table and the
//   file of rows flash_table check BUILD PAGE ROWS EFFECT...            on a Cortex-M3 alone: measures and compares
//   with both
// BUILD has for each machine a folder with the programs k5_BITS_METHODS and what they printed, k5_BITS_METHODS.drawn.
// No EFFECT: all. Exit status: 0 done, 1 why not, 2 wrong words.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware_symbols.hpp"
#include "flash_rows.hpp"
#include "k5.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;
namespace fs = std::filesystem;

std::string program_of(Effects effects) {
  std::ostringstream name;
  name << std::hex << effects.bits << '_' << effects.methods;
  return name.str();
}

std::vector<Comparison> chosen(std::span<char*> effects) {
  if (effects.empty()) return {std::begin(kComparisons), std::end(kComparisons)};
  std::vector<Comparison> found;
  for (const std::string effect : effects) {
    const auto* const comparison = std::ranges::find(kComparisons, effect, &Comparison::effect);
    if (comparison == std::end(kComparisons)) throw std::runtime_error("there is no effect " + effect);
    found.push_back(*comparison);
  }
  return found;
}

struct Drawn {
  std::string crc32;
  std::uint32_t arena = 0, instructions = 0;
};

Drawn drawn_by(const fs::path& program) {
  Drawn drawn;
  std::ifstream stream(program.string() + ".drawn");
  if (!(stream >> drawn.crc32 >> drawn.arena >> drawn.instructions)) {
    throw std::runtime_error(program.string() + " has drawn nothing");
  }
  return drawn;
}

void measure(std::vector<FlashRow>& rows, const Comparison& comparison, const fs::path& build,
             const std::string& machine) {
  const std::string effect(comparison.effect);
  const fs::path with = build / machine / ("k5_" + program_of(comparison.effects()));
  const fs::path without = build / machine / ("k5_" + program_of(comparison.without_it()));
  const Drawn drawn_with = drawn_by(with), drawn_without = drawn_by(without);
  if ((drawn_with.crc32 == drawn_without.crc32) != comparison.draws_the_same) {
    throw std::runtime_error(effect + " on " + machine + ": K5 is drawn " +
                             (comparison.draws_the_same ? "otherwise with it" : "the same, which k5.hpp denies"));
  }
  FirmwareSizes sizes_with = sizes_of(with), sizes_without = sizes_of(without);
  for (const char* section : kSections) {
    rows.push_back({machine, effect, section, sizes_without.sections[section], sizes_with.sections[section], ""});
  }
  rows.push_back({machine, effect, kInstructions, drawn_without.instructions, drawn_with.instructions, ""});
  if (machine != kMachineOfSymbols) return;
  for (const auto& [key, bytes] : sizes_with.symbols) sizes_without.symbols.try_emplace(key, 0);
  for (const auto& [key, bytes] : sizes_without.symbols) {
    const std::uint32_t bytes_with = sizes_with.symbols[key];
    if (bytes_with != bytes) rows.push_back({machine, effect, key.first, bytes, bytes_with, key.second});
  }
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return text;
}

void write(const fs::path& build, const fs::path& page, const fs::path& file, std::span<char*> effects) {
  std::vector<FlashRow> measured, rows;
  for (const Comparison& comparison : chosen(effects)) {
    for (const char* machine : kMachines) measure(measured, comparison, build, machine);
  }
  // Rows that were not measured stay as they are.
  if (!effects.empty()) rows = read_rows(file);
  std::erase_if(rows,
                [&](const FlashRow& row) { return std::ranges::count(measured, row.effect, &FlashRow::effect) != 0; });
  rows.insert(rows.end(), measured.begin(), measured.end());
  std::ranges::stable_sort(rows, {}, [](const FlashRow& row) {
    return std::ranges::find(kComparisons, row.effect, &Comparison::effect) - kComparisons;
  });
  const std::string fresh = page_with_table(contents(page), rows);
  write_rows(file, rows);
  std::ofstream(page) << fresh;
}

bool is_instructions(const FlashRow& row) { return row.section == kInstructions; }

/// Sections and symbols are equal, instructions within 2 %.
bool agrees(const FlashRow& measured, const FlashRow& published) {
  if (!is_instructions(measured)) return measured == published;
  const auto is_near = [](std::uint32_t a, std::uint32_t b) { return (a > b ? a - b : b - a) <= b / 50; };
  return is_instructions(published) && is_near(measured.with, published.with) &&
         is_near(measured.without, published.without);
}

bool check(const fs::path& build, const fs::path& page, const fs::path& file, std::span<char*> effects) {
  const std::vector<FlashRow> rows = read_rows(file);
  bool right = contents(page) == page_with_table(contents(page), rows);
  if (!right) std::cerr << page.string() << " has another table than " << file.string() << " makes\n";
  for (const Comparison& comparison : chosen(effects)) {
    std::vector<FlashRow> measured, published;
    measure(measured, comparison, build, kMachineOfSymbols);
    std::ranges::copy_if(rows, std::back_inserter(published), [&](const FlashRow& row) {
      return row.machine == kMachineOfSymbols && row.effect == comparison.effect;
    });
    const bool equal = std::ranges::equal(measured, published, agrees);
    right = right && equal;
    std::cout << (equal ? "agrees: " : "differs: ") << comparison.effect << ", " << measured.size() << " rows\n";
    if (equal) continue;
    const auto print = [](const char* whose, const FlashRow& row) {
      std::cout << "  " << whose << ' ' << row.section << ' ' << row.symbol << ": " << row.without << ", " << row.with
                << '\n';
    };
    for (const FlashRow& row : measured) {
      if (std::ranges::count(published, row) == 0) print("measured", row);
    }
    for (const FlashRow& row : published) {
      if (std::ranges::count(measured, row) == 0) print("published", row);
    }
  }
  return right;
}

void print_programs(std::span<char*> effects) {
  std::vector<std::string> programs;
  for (const Comparison& comparison : chosen(effects)) {
    programs.push_back(program_of(comparison.effects()));
    programs.push_back(program_of(comparison.without_it()));
  }
  std::ranges::sort(programs);
  programs.erase(std::unique(programs.begin(), programs.end()), programs.end());
  for (const std::string& program : programs) std::cout << program << '\n';
}

}  // namespace

int main(int count, char** words) {
  const std::span all(words, static_cast<std::size_t>(count));
  const std::string command = count > 1 ? words[1] : "";
  try {
    if (command == "programs") {
      print_programs(all.subspan(2));
      return 0;
    }
    if (command == "write" && count >= 5) {
      write(words[2], words[3], words[4], all.subspan(5));
      return 0;
    }
    if (command == "check" && count >= 6) return check(words[2], words[3], words[4], all.subspan(5)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "flash_table: " << error.what() << '\n';
    return 1;
  }
  std::cerr << "usage: flash_table programs [EFFECT...] | write BUILD PAGE ROWS [EFFECT...] | check BUILD PAGE ROWS "
               "EFFECT...\n";
  return 2;
}
