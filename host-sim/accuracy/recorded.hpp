// Recorded figures (docs/measured/accuracy.csv), for plots and tables.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/campaign.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// A CSV file without quotes. Missing fields at the end of a line are empty.
class RecordedTable {
 public:
  using Row = std::vector<std::string>;
  /// The first columns must be `first`. Failures: ExitStatus::input for a file that cannot be read, or with other
  /// columns.
  static Result<RecordedTable> read(const std::string& file, const std::vector<std::string>& first);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// Returns the field, empty if the table does not have the column.
  std::string field(const Row& row, std::string_view name) const;
  /// Returns the row whose first fields are `first`, or null.
  const Row* find(const std::vector<std::string>& first) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<Row> rows_;
};

/// Returns the scenes of a table that accuracy_csv() wrote, with the instructions of the Cortex-M3, in the table's
/// order. Lines without instructions are left out. Failures: ExitStatus::input for a table of another form.
Result<std::vector<Campaign>> recorded_campaigns(const RecordedTable& table);

}  // namespace zstrip::sim
