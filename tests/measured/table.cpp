// Reads, writes, compares and merges tables of figures.
#include "measured/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace zstrip::measured {
namespace {

constexpr std::string_view kNote = "# ";

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

Row cells_of(const std::string& line) {
  Row cells(1);
  for (const char character : line) {
    if (character == ',')
      cells.emplace_back();
    else
      cells.back() += character;
  }
  return cells;
}

std::string headings(const Table& table) {
  std::string line;
  for (const Column& column : table.columns) line += (line.empty() ? "" : ",") + column.name;
  return line;
}

bool cell_agrees(const Column& column, const std::string& recorded, const std::string& measured) {
  if (recorded == measured) return true;
  if (column.tolerance->share == 0 && column.tolerance->at_least == 0) return false;
  const auto was = number(recorded), is = number(measured);
  return was && is && agrees(*was, *is, *column.tolerance);
}

std::string name_of(const Table& table, const Row& row) {
  std::string name;
  for (std::size_t i = 0; i < table.columns.size() && !table.columns[i].tolerance; ++i) {
    name += (i == 0 ? "" : ", ") + row.at(i);
  }
  return name;
}

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// "+508, +1.54 %".
std::string difference(double recorded, double measured) {
  std::string text = formatted("%+.10g", measured - recorded);
  if (recorded != 0) text += formatted(", %+.2f %%", 100 * (measured - recorded) / std::abs(recorded));
  return text;
}

std::string allowance(Tolerance tolerance) {
  std::string text;
  if (tolerance.share != 0) text += formatted("%.10g %%", 100 * tolerance.share);
  if (tolerance.at_least != 0) text += (text.empty() ? "" : " or ") + formatted("%.10g", tolerance.at_least);
  return text.empty() ? "it must be equal" : text + " either way is allowed";
}

}  // namespace

bool agrees(double recorded, double measured, Tolerance tolerance) {
  return std::abs(measured - recorded) <= std::max(tolerance.share * std::abs(recorded), tolerance.at_least);
}

const Row* Table::find(const Row& row) const {
  const auto names = std::ranges::find_if(columns, [](const Column& column) { return column.tolerance.has_value(); });
  const auto count = names - columns.begin();
  const auto same = [&](const Row& other) { return std::equal(row.begin(), row.begin() + count, other.begin()); };
  const auto found = std::ranges::find_if(rows, same);
  return found == rows.end() ? nullptr : &*found;
}

Table read_table(const std::filesystem::path& file, Table format) {
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error("cannot read " + file.string() + "; tests/measure " + format.part + " writes it");
  int count = 0;
  bool has_headings = false;
  for (std::string line; std::getline(stream, line);) {
    ++count;
    const auto fail = [&](const std::string& why) {
      throw std::runtime_error(file.string() + ":" + std::to_string(count) + ": " + why);
    };
    if (!has_headings && line.starts_with(kNote)) {
      format.notes.push_back(line.substr(kNote.size()));
    } else if (!has_headings) {
      if (line != headings(format)) fail("the columns are not " + headings(format));
      has_headings = true;
    } else {
      Row row = cells_of(line);
      if (row.size() != format.columns.size()) fail("a row has " + std::to_string(format.columns.size()) + " columns");
      if (format.find(row) != nullptr) fail(name_of(format, row) + " is there twice");
      format.rows.push_back(std::move(row));
    }
  }
  if (!has_headings) throw std::runtime_error(file.string() + ": no columns");
  return format;
}

void write_table(const std::filesystem::path& file, const Table& table) {
  std::ostringstream text;
  for (const std::string& note : table.notes) text << kNote << note << '\n';
  text << headings(table) << '\n';
  for (const Row& row : table.rows) {
    if (row.size() != table.columns.size()) throw std::logic_error("a row of " + table.part + " lacks columns");
    for (std::size_t i = 0; i < row.size(); ++i) text << (i == 0 ? "" : ",") << row[i];
    text << '\n';
  }
  std::ofstream stream(file);
  stream << text.str() << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

std::string differences(const Table& recorded, const Row& measured) {
  const std::string name = name_of(recorded, measured);
  const Row* const row = recorded.find(measured);
  if (row == nullptr) return name + ": nothing is recorded\n";
  std::string lines;
  for (std::size_t i = 0; i < recorded.columns.size(); ++i) {
    const Column& column = recorded.columns[i];
    if (!column.tolerance || cell_agrees(column, row->at(i), measured.at(i))) continue;
    lines += name + ": " + column.name + " is " + measured[i] + ", recorded " + row->at(i);
    if (const auto was = number(row->at(i)), is = number(measured[i]); was && is) {
      lines += " (" + difference(*was, *is) + "; " + allowance(*column.tolerance) + ")";
    }
    lines += '\n';
  }
  return lines;
}

std::string complaint(const Table& recorded, const Row& measured) {
  const std::string command = "tests/measure " + recorded.part + " " + measured.at(0);
  std::string lines = differences(recorded, measured);
  if (recorded.find(measured) == nullptr) {
    lines += command + " records it\n";
  } else if (!lines.empty()) {
    lines += "if it is worth it, " + command + " accepts it; say why in the commit\n";
  }
  return lines;
}

Table merged(const Table& recorded, const Table& measured, bool exact, bool whole) {
  const bool same_notes = recorded.notes == measured.notes;
  if (!whole && !same_notes && !recorded.rows.empty()) {
    throw std::runtime_error("the recorded figures hold for something else, compilers perhaps: measure all of " +
                             recorded.part);
  }
  Table result = measured;
  if (!exact && same_notes) {
    for (Row& row : result.rows) {
      const Row* const known = recorded.find(row);
      for (std::size_t i = 0; known != nullptr && i < row.size(); ++i) {
        const Column& column = recorded.columns[i];
        if (column.tolerance && cell_agrees(column, known->at(i), row[i])) row[i] = known->at(i);
      }
    }
  }
  if (whole) return result;
  std::vector<Row> rows;
  for (const Row& row : recorded.rows) {
    const Row* const fresh = result.find(row);
    rows.push_back(fresh == nullptr ? row : *fresh);
  }
  for (const Row& row : result.rows) {
    if (recorded.find(row) == nullptr) rows.push_back(row);
  }
  result.rows = std::move(rows);
  return result;
}

}  // namespace zstrip::measured
