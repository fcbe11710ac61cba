// What K5's firmware takes with and without each effect: the rows of docs/effects-symbols.csv, and the table in
// docs/effects.md that is made of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace zstrip::effects_cost {

inline constexpr const char* kMachines[] = {"m0", "m3", "m4f"};
inline constexpr const char* kMachineOfSymbols = "m3";
inline constexpr const char* kSections[] = {".text", ".rodata", ".data", ".bss"};
inline constexpr const char* kInstructions = "instructions";  ///< in place of a section: of a frame

/// Bytes of a section, or of what has one name in it: only symbols that differ.
struct FlashRow {
  std::string machine;
  std::string effect;
  std::string section;
  std::uint32_t without;
  std::uint32_t with;
  std::string symbol;  ///< firmware_symbols.hpp's reader_name; empty: the whole section

  bool is_new() const { return !symbol.empty() && without == 0; }
  friend bool operator==(const FlashRow&, const FlashRow&) = default;
};

/// Throw std::runtime_error if the file cannot be read or written, or is not what write_rows writes.
std::vector<FlashRow> read_rows(const std::filesystem::path& file);
void write_rows(const std::filesystem::path& file, std::span<const FlashRow> rows);

/// The page with its table made of these rows. Throws std::runtime_error if it has no place for it.
std::string page_with_table(const std::string& page, std::span<const FlashRow> rows);

}  // namespace zstrip::effects_cost
