// Figures that were written down before (docs/measured/accuracy.csv), to be drawn and tabulated again.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/campaign.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// A CSV file without quotes. A field that a line ends before is empty.
class RecordedTable {
 public:
  using Row = std::vector<std::string>;
  /// Its first columns are `first`. Failures: ExitStatus::input for a file that cannot be read, or without these.
  static Result<RecordedTable> read(const std::string& file, const std::vector<std::string>& first);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// Empty for a column that the table does not have.
  std::string field(const Row& row, std::string_view name) const;
  /// The first row whose first fields are these; null if there is none.
  const Row* find(const std::vector<std::string>& first) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<Row> rows_;
};

/// The scenes of a table as accuracy_csv() writes it, with the instructions of the Cortex-M3; in its order, lines
/// without these left out. Failures: ExitStatus::input for a table of another form.
Result<std::vector<Campaign>> recorded_campaigns(const RecordedTable& table);

}  // namespace zstrip::sim
