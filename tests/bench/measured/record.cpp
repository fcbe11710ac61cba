// Records what `zstrip bench` measured in docs/measured and writes the page of it: record PART FRESH [--exact]
// [TABLE...]. FRESH is the folder into which the part's script put what was printed.
#include <fstream>
#include <stdexcept>

#include "bench/measured/tables.hpp"
#include "measured/update.hpp"

namespace {

using namespace zstrip::measured;
namespace fs = std::filesystem;

const fs::path kFolder = ZSTRIP_MEASURED;

std::string file_of(const std::string& part, const BenchTable& table) { return part + "-" + table.name + ".csv"; }

/// Millions are read more easily in groups of three digits.
std::string grouped(const std::string& cell) {
  if (cell.size() < 4 || cell.find_first_not_of("0123456789") != std::string::npos) return cell;
  std::string text = cell;
  for (std::size_t at = text.size() - 3; at < text.size(); at -= 3) text.insert(at, at == 0 ? "" : ",");
  return text;
}

std::string section(const std::string& part, const BenchTable& table) {
  std::string text = "\n## " + table.title + "\n" + table.note + "\n[CSV](" + file_of(part, table) + ")\n\n|";
  std::string rule = "|";
  for (const Column& column : table.format.columns) {
    text += " " + column.name + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const Row& row : read_table(kFolder / file_of(part, table), table.format).rows) {
    text += "|";
    for (const std::string& cell : row) text += " " + grouped(cell) + " |";
    text += "\n";
  }
  return text;
}

void write_page(const std::string& part, const std::vector<BenchTable>& tables) {
  std::ofstream page(kFolder / (part + ".md"));
  page << "# What was measured: " << part << "\n\nWritten by `tests/measure " << part << "`. [The page on " << part
       << "](../" << part << ".md) says what it means.\n";
  for (const BenchTable& table : tables) page << section(part, table);
  if (!page.flush()) throw std::runtime_error("cannot write the page of " + part);
}

/// What is off in a table, and the command that accepts it; empty if nothing is.
std::string compared(const std::string& part, const BenchTable& table, const fs::path& fresh) {
  const Table recorded = read_table(kFolder / file_of(part, table), table.format);
  const std::vector<Row> rows = table.rows(fresh);
  std::string text;
  for (const Row& row : rows) text += differences(recorded, row);
  if (rows.size() != recorded.rows.size()) text += table.name + ": other rows are recorded\n";
  if (!text.empty()) text += "if it is worth it, tests/measure " + part + " " + table.name + " accepts it\n";
  return text;
}

void record(const std::string& part, const fs::path& fresh, Choice choice) {
  const bool compare = std::erase(choice.rows, "--compare") != 0;
  const std::vector<BenchTable> tables = tables_of(part);
  if (tables.empty()) throw std::runtime_error("there is no part " + part);
  std::vector<std::string> names;
  for (const BenchTable& table : tables) names.push_back(table.name);
  check(choice, names);
  std::string off;
  for (const BenchTable& table : tables) {
    if (!choice.has(table.name)) continue;
    if (compare) {
      off += compared(part, table, fresh);
      continue;
    }
    Table measured = table.format;
    measured.rows = table.rows(fresh);
    const fs::path file = kFolder / file_of(part, table);
    write_table(file, merged(recorded_or_empty(file, table.format), measured, choice.exact, true));
  }
  if (!off.empty()) throw std::runtime_error(off);
  if (!compare) write_page(part, tables);
}

}  // namespace

int main(int count, char** words) {
  return run_update(
      count, words, "record PART FRESH", 2,
      [](const std::vector<std::string>& before, const Choice& choice) { record(before[0], before[1], choice); });
}
