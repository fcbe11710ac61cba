// The committed budgets and sizes of symbols, and what to say when a program takes more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "usage.hpp"

namespace zstrip::budget {

/// Bytes by program and scene, in the order of the columns of the file.
using Budgets = std::map<std::pair<std::string, std::string>, std::vector<std::uint32_t>>;

/// Throw std::runtime_error if the file is not what write_budgets writes.
Budgets read_budgets(const std::filesystem::path& file);
void write_budgets(const std::filesystem::path& file, std::span<const Usage> usages);

/// The largest symbols by program, of each memory so many.
using SymbolTable = std::map<std::string, std::vector<SymbolSize>>;
inline constexpr std::size_t kSymbolsOfMemory = 20;

SymbolTable read_symbols(const std::filesystem::path& file);
void write_symbols(const std::filesystem::path& file, const SymbolTable& symbols);

/// Lines that say by how much each quantity is over its budget; empty if none is.
std::string over_budget(const Usage& usage, const Budgets& budgets);

/// Lines that say which of the program's symbols are larger than in the table, or not in it and large enough to be; the
/// most grown first.
std::string grown_symbols(std::span<const SymbolSize> now, std::span<const SymbolSize> before);

}  // namespace zstrip::budget
