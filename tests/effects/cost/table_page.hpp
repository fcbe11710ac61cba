// What the two pages for readers share: rows by effect, and numbers of several machines in one cell.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::effects_cost {

inline std::string notes_of(const measured::Table& table) {
  std::string text;
  for (const std::string& note : table.notes) text += "- " + note + '\n';
  return text;
}

/// In the order of the table.
inline std::vector<std::string> effects_in(const measured::Table& table) {
  std::vector<std::string> effects;
  for (const measured::Row& row : table.rows) {
    if (std::ranges::find(effects, row[0]) == effects.end()) effects.push_back(row[0]);
  }
  return effects;
}

inline std::vector<measured::Row> rows_of(const measured::Table& table, const std::string& effect) {
  std::vector<measured::Row> rows;
  std::ranges::copy_if(table.rows, std::back_inserter(rows),
                       [&](const measured::Row& row) { return row[0] == effect; });
  return rows;
}

/// "1 / 2 / 3"; one of them if all are equal.
inline std::string joined(std::vector<std::string> cells) {
  if (std::ranges::adjacent_find(cells, std::ranges::not_equal_to()) == cells.end() && !cells.empty()) cells.resize(1);
  std::string text;
  for (const std::string& cell : cells) text += (text.empty() ? "" : " / ") + cell;
  return text;
}

}  // namespace zstrip::effects_cost
