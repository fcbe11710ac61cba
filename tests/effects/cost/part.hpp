// The commands of a program that measures a part: what its rows are called, which programs they need, measuring and
// checking.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "measured/update.hpp"

namespace zstrip::effects_cost {

using Names = std::vector<std::string>;

/// Rows have the names of effects.
struct Part {
  measured::Table format;  ///< of its table
  Names notes;             ///< what figures hold for here
  Names names;             ///< of all rows
  Names usual{};           ///< the rows that are checked in any case; the others take ZSTRIP_LONG
  /// The programs that the rows of an effect need, as name_of says.
  std::function<std::set<std::string>(const std::string& effect)> programs;
  /// On the machines, programs lying in BUILD/MACHINE; `machines` may have more than boards.
  std::function<std::vector<measured::Row>(const std::string& effect, const std::filesystem::path& build,
                                           const Names& machines)>
      measure;
  std::function<std::string(const measured::Table& table)> page;
  /// Lines that say what else is wrong of programs on kCheckedMachine; empty if nothing is.
  std::function<std::string(const std::string& effect, const std::filesystem::path& build)> check;
};

/// `words` of the program:
///   names                    of all rows
///   usual                    names of the rows that are checked in any case
///   programs [ROW...]        what is to be built for them
///   measure BUILD FILE MACHINES [--exact] [ROW...]
///                            writes FILE.csv and FILE.md; MACHINES are separated by commas
///   check BUILD FILE ROW...  compares with FILE.csv, on kCheckedMachine alone
/// Exit status: 0 done, 1 why not, 2 wrong words, 77 the recorded figures are those of other compilers.
int run_part(int count, char** words, const Part& part);

}  // namespace zstrip::effects_cost
