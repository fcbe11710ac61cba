// A table of recorded figures: its file, and how far a fresh measurement may be from it, in both directions.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zstrip::measured {

/// How far a figure may be from the recorded one: the larger of the two.
struct Tolerance {
  double share = 0;     ///< of the recorded figure, 0.01 is 1 %
  double at_least = 0;  ///< in the figure's unit
};
inline constexpr Tolerance kExact{}, kFlash{.share = 0.01}, kInstructions{.share = 0.01};

/// Whether `measured` is near enough to `recorded`. A bound that is met counts as near.
bool agrees(double recorded, double measured, Tolerance tolerance);

/// A column of words that name the row, if it has no tolerance; else of figures. What is exact, or no number, agrees
/// only with the same text.
struct Column {
  std::string name;
  std::optional<Tolerance> tolerance{};
};

/// One text a column, without commas.
using Row = std::vector<std::string>;

/// Columns that name rows come first. No two rows have the same words there.
struct Table {
  std::string part;                  ///< of tests/measure, which writes the table
  std::vector<Column> columns{};     ///< one has no tolerance at least
  std::vector<std::string> notes{};  ///< lines before the headings: what the figures hold for, compilers above all
  std::vector<Row> rows{};

  /// The row of the same name, or null.
  const Row* find(const Row& row) const;
};

/// Fills rows and notes of a table without any. A file is comma-separated values; notes begin with "# ". Throws
/// std::runtime_error that says which line is not as it must be.
Table read_table(const std::filesystem::path& file, Table format);
void write_table(const std::filesystem::path& file, const Table& table);

/// Lines that say which figures of a row are off, and by how much; empty if none is.
std::string differences(const Table& recorded, const Row& measured);
/// The same, and which command accepts them.
std::string complaint(const Table& recorded, const Row& measured);

/// The recorded table with what was measured in place of what is off. Figures that agree keep their recorded value, but
/// not with `exact` or other notes. `whole`: rows that were not measured are gone; else they stay. Throws
/// std::runtime_error if some should stay beside other notes.
Table merged(const Table& recorded, const Table& measured, bool exact, bool whole);

}  // namespace zstrip::measured
