// What the programs share that write a table of docs/measured: their words, what they say, their exit status.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::measured {

/// What is to be measured: `[--exact] [ROW...]`.
struct Choice {
  bool exact = false;               ///< figures that agree are written, too
  std::vector<std::string> rows{};  ///< words of the first column; empty: all

  bool whole() const { return rows.empty(); }
  bool has(const std::string& row) const;
};

/// A row that does not exist is asked for.
class UnknownRow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws UnknownRow that names the rows that there are, if one is asked for that is not among them.
void check(const Choice& choice, const std::vector<std::string>& known);

/// The recorded table, or an empty one if there is no file yet.
Table recorded_or_empty(const std::filesystem::path& file, const Table& format);

/// Says on standard error what is measured now.
void say_progress(const std::string& part, std::size_t done, std::size_t all, const std::string& what);

/// Runs `body` with the words of a program, `USAGE [--exact] [ROW...]` with so many words before. Returns the exit
/// status: 0 written, 1 why not, 2 wrong words.
int run_update(int count, char** words, const std::string& usage, std::size_t words_before,
               const std::function<void(const std::vector<std::string>& before, const Choice& choice)>& body);

}  // namespace zstrip::measured
