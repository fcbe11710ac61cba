// Reads, writes and compares the two tables, as comma-separated values.
#include "budget_file.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace zstrip::budget {
namespace {

/// One column of the budgets.
struct Quantity {
  const char* name;
  std::uint32_t Usage::*bytes;
  std::uint32_t step;  // budgets are multiples of this: small changes of flash need no new budget
};
constexpr Quantity kQuantities[] = {
    {"code", &Usage::code, 512},       {"constants", &Usage::constants, 512}, {"initial_data", &Usage::initial_data, 8},
    {"arena", &Usage::arena, 8},       {"pixels", &Usage::pixels, 8},         {"statics", &Usage::statics, 64},
    {"stack", &Usage::stack_bound, 64}};
constexpr std::string_view kFlash = "flash", kRam = "ram";
constexpr const char* kSymbolsHeader = "program,memory,bytes,symbol";

std::string budgets_header() {
  std::string header = "program,scene";
  for (const Quantity& quantity : kQuantities) header += std::string(",") + quantity.name;
  return header;
}

std::uint32_t number(const std::string& text, const std::string& line) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::runtime_error("not a number in: " + line);
  return value;
}

/// Lines behind the header.
std::vector<std::string> read_lines(const std::filesystem::path& file, const std::string& header) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line) || line != header) {
    throw std::runtime_error(file.string() + " does not begin with " + header);
  }
  std::vector<std::string> lines;
  while (std::getline(stream, line)) lines.push_back(line);
  return lines;
}

/// At most `count` fields; the last one may hold commas.
std::vector<std::string> fields(const std::string& line, std::size_t count) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  std::string field;
  while (result.size() + 1 < count && std::getline(stream, field, ',')) result.push_back(field);
  if (std::getline(stream, field)) result.push_back(field);
  if (result.size() != count) throw std::runtime_error("too few fields in: " + line);
  return result;
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

std::uint32_t rounded_up(std::uint32_t bytes, std::uint32_t step) { return (bytes + step - 1) / step * step; }

}  // namespace

Budgets read_budgets(const std::filesystem::path& file) {
  Budgets budgets;
  for (const std::string& line : read_lines(file, budgets_header())) {
    const std::vector<std::string> field = fields(line, 2 + std::size(kQuantities));
    std::vector<std::uint32_t>& bytes = budgets[{field[0], field[1]}];
    if (!bytes.empty()) throw std::runtime_error("given twice: " + line);
    for (std::size_t i = 2; i < field.size(); ++i) bytes.push_back(number(field[i], line));
  }
  return budgets;
}

void write_budgets(const std::filesystem::path& file, std::span<const Usage> usages) {
  std::ostringstream text;
  text << budgets_header() << '\n';
  for (const Usage& usage : usages) {
    text << usage.target->program << ',' << usage.target->scene;
    for (const Quantity& quantity : kQuantities) text << ',' << rounded_up(usage.*quantity.bytes, quantity.step);
    text << '\n';
  }
  write_file(file, text.str());
}

SymbolTable read_symbols(const std::filesystem::path& file) {
  SymbolTable symbols;
  for (const std::string& line : read_lines(file, kSymbolsHeader)) {
    const std::vector<std::string> field = fields(line, 4);
    if (field[1] != kFlash && field[1] != kRam) throw std::runtime_error("no memory of a board: " + line);
    symbols[field[0]].push_back({field[3], number(field[2], line), field[1] == kRam});
  }
  return symbols;
}

void write_symbols(const std::filesystem::path& file, const SymbolTable& symbols) {
  std::ostringstream text;
  text << kSymbolsHeader << '\n';
  for (const auto& [program, sizes] : symbols) {
    std::size_t written[2] = {};
    for (const SymbolSize& symbol : sizes) {
      if (written[symbol.in_ram]++ >= kSymbolsOfMemory) continue;
      text << program << ',' << (symbol.in_ram ? kRam : kFlash) << ',' << symbol.bytes << ',' << symbol.name << '\n';
    }
  }
  write_file(file, text.str());
}

std::string over_budget(const Usage& usage, const Budgets& budgets) {
  const auto found = budgets.find({usage.target->program, usage.target->scene});
  if (found == budgets.end()) return "it has no budget\n";
  std::ostringstream text;
  for (std::size_t i = 0; i < std::size(kQuantities); ++i) {
    const std::uint32_t bytes = usage.*kQuantities[i].bytes, budget = found->second[i];
    if (bytes <= budget) continue;
    text << kQuantities[i].name << ": " << bytes << " bytes, " << bytes - budget << " over the budget of " << budget
         << '\n';
  }
  return text.str();
}

std::string grown_symbols(std::span<const SymbolSize> now, std::span<const SymbolSize> before) {
  std::map<std::pair<bool, std::string>, std::uint32_t> known;
  // A symbol that is not in the table had no more than the smallest one there, or did not exist if there was room.
  std::uint32_t smallest[2] = {~0U, ~0U};
  std::size_t listed[2] = {};
  for (const SymbolSize& symbol : before) {
    known[{symbol.in_ram, symbol.name}] = symbol.bytes;
    smallest[symbol.in_ram] = std::min(smallest[symbol.in_ram], symbol.bytes);
    ++listed[symbol.in_ram];
  }
  for (const bool in_ram : {false, true}) {
    if (listed[in_ram] < kSymbolsOfMemory) smallest[in_ram] = 0;
  }
  std::multimap<std::uint32_t, std::string, std::greater<>> grown;
  for (const SymbolSize& symbol : now) {
    const auto found = known.find({symbol.in_ram, symbol.name});
    const std::uint32_t had = found == known.end() ? smallest[symbol.in_ram] : found->second;
    if (symbol.bytes <= had) continue;
    const std::string growth =
        found == known.end() ? "not among the largest before" : "grown by " + std::to_string(symbol.bytes - had);
    grown.emplace(symbol.bytes - had, (symbol.in_ram ? "RAM, " : "flash, ") + std::to_string(symbol.bytes) +
                                          " bytes, " + growth + ": " + symbol.name);
  }
  std::string text;
  for (const auto& [growth, line] : grown) text += "  " + line + '\n';
  return text;
}

}  // namespace zstrip::budget
