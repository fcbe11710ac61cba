// Reads and writes rows; a line of the table for each effect.
#include "flash_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "firmware_symbols.hpp"
#include "k5.hpp"

namespace zstrip::effects_cost {
namespace {

constexpr std::string_view kHeading = "machine,effect,section,bytes without,bytes with,symbol";
constexpr std::string_view kBegin = "<!-- The next table is written by tests/effects/cost/flash. -->\n";
constexpr std::string_view kEnd = "<!-- End of the table of K5. -->\n";
constexpr std::size_t kLargest = 3;

std::uint32_t number(const std::string& text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::runtime_error("not a number: " + text);
  return value;
}

using Rows = std::span<const FlashRow>;

/// On each machine how much more it is with the effect; one number if all are equal.
std::string more(Rows rows, std::string_view effect, std::string_view section) {
  std::vector<std::int64_t> differences;
  for (const char* machine : kMachines) {
    for (const FlashRow& row : rows) {
      if (row.effect != effect || row.machine != machine || row.section != section || !row.symbol.empty()) continue;
      differences.push_back(std::int64_t{row.with} - row.without);
    }
  }
  const bool equal =
      std::adjacent_find(differences.begin(), differences.end(), std::not_equal_to<>()) == differences.end();
  if (equal && !differences.empty()) differences.resize(1);
  std::string text;
  for (const std::int64_t difference : differences) {
    if (!text.empty()) text += " / ";
    text += std::to_string(difference);
  }
  return text;
}

/// How many, and the largest of them: those that differ in template arguments alone together.
std::pair<std::size_t, std::string> new_symbols(Rows rows, std::string_view effect) {
  std::size_t count = 0;
  std::map<std::string, std::uint32_t> bytes;
  for (const FlashRow& row : rows) {
    if (row.effect != effect || !row.is_new()) continue;
    ++count;
    bytes[without_arguments(row.symbol)] += row.with;
  }
  std::vector<std::pair<std::string, std::uint32_t>> largest(bytes.begin(), bytes.end());
  std::stable_sort(largest.begin(), largest.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (largest.size() > kLargest) largest.resize(kLargest);
  std::ostringstream text;
  for (const auto& [name, size] : largest) text << (text.tellp() == 0 ? "`" : ", `") << name << "` " << size;
  return {count, text.str()};
}

/// The names of effects that both programs have.
std::string beside(const Comparison& comparison) {
  std::string text;
  for (const Comparison& other : kComparisons) {
    if (comparison.beside == Effects{} || !comparison.beside.has(other.added)) continue;
    if (!text.empty()) text += ", ";
    text += "`";
    text += other.effect;
    text += "`";
  }
  return text;
}

}  // namespace

std::vector<FlashRow> read_rows(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line) || line != kHeading) throw std::runtime_error(file.string() + ": no rows");
  std::vector<FlashRow> rows;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    FlashRow row{};
    std::string without, with;
    for (std::string* const word : {&row.machine, &row.effect, &row.section, &without, &with}) {
      if (!std::getline(words, *word, ',')) throw std::runtime_error(file.string() + ": not a row: " + line);
    }
    std::getline(words, row.symbol);
    row.without = number(without);
    row.with = number(with);
    rows.push_back(std::move(row));
  }
  return rows;
}

void write_rows(const std::filesystem::path& file, std::span<const FlashRow> rows) {
  std::ofstream stream(file);
  stream << kHeading << '\n';
  for (const FlashRow& row : rows) {
    stream << row.machine << ',' << row.effect << ',' << row.section << ',' << row.without << ',' << row.with << ','
           << row.symbol << '\n';
  }
  stream.flush();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

std::string page_with_table(const std::string& page, std::span<const FlashRow> rows) {
  const std::size_t begin = page.find(kBegin), end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    throw std::runtime_error("the page has no place for the table of K5");
  }
  std::ostringstream table;
  table << "| Effect | Beside | `.text` | `.rodata` | `.data` | `.bss` | New symbols | The largest of them | "
           "Instructions a frame |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Comparison& comparison : kComparisons) {
    table << "| `" << comparison.effect << "` | " << beside(comparison) << " |";
    for (const char* section : kSections) table << ' ' << more(rows, comparison.effect, section) << " |";
    const auto [count, largest] = new_symbols(rows, comparison.effect);
    table << ' ' << count << " | " << largest << " | " << more(rows, comparison.effect, kInstructions) << " |\n";
  }
  return page.substr(0, begin + kBegin.size()) + table.str() + page.substr(end);
}

}  // namespace zstrip::effects_cost
