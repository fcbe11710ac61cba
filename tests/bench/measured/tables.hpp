// The tables of docs/measured that `zstrip bench` and the store's benchmark fill: their columns, and how to read them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::measured {

struct BenchTable {
  std::string name;         ///< as tests/measure knows it; PART-NAME.csv holds it
  std::string title, note;  ///< of its section of the page
  Table format;             ///< without rows
  /// From what the part's script left in a folder. Throws std::exception for files of another form.
  std::function<std::vector<Row>(const std::filesystem::path& fresh)> rows;
};

/// "performance" or "visibility": its tables in the order of its page; none of another name.
std::vector<BenchTable> tables_of(const std::string& part);

}  // namespace zstrip::measured
