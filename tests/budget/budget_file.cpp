// Reads, writes and compares the two tables, as comma-separated values.
#include "budget_file.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace zstrip::budget {
namespace {

constexpr Quantity kQuantities[] = {
    {"code", &Usage::code, 512},       {"constants", &Usage::constants, 512}, {"initial_data", &Usage::initial_data, 8},
    {"arena", &Usage::arena, 8},       {"pixels", &Usage::pixels, 8},         {"statics", &Usage::statics, 64},
    {"stack", &Usage::stack_bound, 64}};
constexpr const char* kSymbolsHeader = "program,bytes,symbol";

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

std::span<const Quantity> quantities() { return kQuantities; }

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
    const std::vector<std::string> field = fields(line, 3);
    symbols[field[0]].push_back({field[2], number(field[1], line)});
  }
  return symbols;
}

void write_symbols(const std::filesystem::path& file, const SymbolTable& symbols) {
  std::ostringstream text;
  text << kSymbolsHeader << '\n';
  for (const auto& [program, sizes] : symbols) {
    for (std::size_t i = 0; i < std::min(sizes.size(), kSymbolsOfProgram); ++i) {
      text << program << ',' << sizes[i].bytes << ',' << sizes[i].name << '\n';
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
  // Names may repeat: short names leave out parameters.
  std::map<std::string, std::uint32_t> now_bytes, before_bytes;
  std::uint32_t smallest = before.empty() ? 0 : before[0].bytes;
  for (const SymbolSize& symbol : now) now_bytes[symbol.name] += symbol.bytes;
  for (const SymbolSize& symbol : before) {
    before_bytes[symbol.name] += symbol.bytes;
    smallest = std::min(smallest, symbol.bytes);
  }
  std::multimap<std::uint32_t, std::string, std::greater<>> grown;
  for (const auto& [name, bytes] : now_bytes) {
    const auto known = before_bytes.find(name);
    if (known == before_bytes.end()) {
      if (bytes > smallest)
        grown.emplace(bytes - smallest, std::to_string(bytes) + " bytes, new or not among the largest before: " + name);
    } else if (bytes > known->second) {
      grown.emplace(bytes - known->second,
                    std::to_string(bytes) + " bytes, grown by " + std::to_string(bytes - known->second) + ": " + name);
    }
  }
  std::string text;
  for (const auto& [growth, line] : grown) text += "  " + line + '\n';
  return text;
}

}  // namespace zstrip::budget
