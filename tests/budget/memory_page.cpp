// Writes docs/measured/memory.md: the same figures, in the order in which one asks for them.
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "memory_table.hpp"

namespace zstrip::budget {
namespace {

/// A row and what readers call its program's board.
struct Line {
  const measured::Table& table;
  const measured::Row& row;

  const std::string& text(const char* column) const {
    const auto found = std::ranges::find(table.columns, column, &measured::Column::name);
    return row.at(static_cast<std::size_t>(found - table.columns.begin()));
  }
  std::uint32_t bytes(const char* column) const {
    return static_cast<std::uint32_t>(std::strtoul(text(column).c_str(), nullptr, 10));
  }
  const Target& target() const {
    for (const Target& each : targets()) {
      if (each.program == text("program") && each.scene == text("scene")) return each;
    }
    throw std::runtime_error("there is no program " + text("program") + " with the scene " + text("scene"));
  }
};

/// With a comma before each three digits.
std::string grouped(std::uint32_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string picture(const View& view) {
  return std::to_string(view.width) + "x" + std::to_string(view.height) +
         (view.format == PixelFormat::gray4 ? ", 4 bits" : "");
}

/// Programs with several scenes have one row for all of them.
void write_flash(std::ostringstream& page, const measured::Table& table) {
  page << "| Board | Scene | Code | Constants | Initial data | Flash |\n|---|---|--:|--:|--:|--:|\n";
  for (std::size_t i = 0; i < table.rows.size();) {
    const Line line{table, table.rows[i]};
    std::string scenes;
    for (; i < table.rows.size() && table.rows[i][0] == line.text("program"); ++i) {
      scenes += (scenes.empty() ? "" : ", ") + table.rows[i][1];
    }
    page << "| " << line.target().board << " | " << scenes;
    std::uint32_t flash = 0;
    for (const char* column : {"code", "constants", "initial_data"}) {
      flash += line.bytes(column);
      page << " | " << grouped(line.bytes(column));
    }
    page << " | " << grouped(flash) << " |\n";
  }
}

void write_ram(std::ostringstream& page, const measured::Table& table) {
  page << "| Board | Scene | Picture | Strips | Instances | Extents | Vertices | Depth | Colour | Bins | Pixels | "
          "Statics "
          "| Stack: reserved | bound | measured | RAM |\n"
          "|---|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const measured::Row& row : table.rows) {
    const Line line{table, row};
    page << "| " << line.target().board << " | " << line.text("scene") << " | " << picture(line.target().view) << " | "
         << line.text("strips");
    for (const char* column : {"instances", "extents", "vertices", "depth", "colour", "bins", "pixels", "statics",
                               "stack_reserved", "stack_bound"}) {
      page << " | " << grouped(line.bytes(column));
    }
    const std::uint32_t ram =
        line.bytes("arena") + line.bytes("pixels") + line.bytes("statics") + line.bytes("stack_reserved");
    page << " | " << (line.text("stack_measured").empty() ? "not run" : grouped(line.bytes("stack_measured"))) << " | "
         << grouped(ram) << " |\n";
  }
}

}  // namespace

std::string memory_page(const measured::Table& table) {
  std::ostringstream page;
  page << "# Memory, measured\n\nBytes. [Memory](../memory.md) says what takes them; [memory.csv](memory.csv) has the\n"
          "same figures, and `tests/measure memory` writes both.\n\n";
  for (const std::string& note : table.notes) page << "- " << note << '\n';
  page << '\n';
  write_flash(page, table);
  page
      << "\nInstances to bins are the arena. RAM adds up arena, pixels, statics and the stack that the linker script\n"
         "reserves. The showroom is the demo of layers, whose pools are statics. The benchmarks on the MPS2 hold four\n"
         "scenes at once: their statics are those of all four.\n\n";
  write_ram(page, table);
  return page.str();
}

}  // namespace zstrip::budget
