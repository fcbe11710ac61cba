// Records what pico.mjs has measured in docs/measured/pico.csv and writes the page of it; or compares.
//   zstrip_pico_record write|add LINE... [--exact]
//   zstrip_pico_record check LINE...
// LINE is a row of the table; `write` has all of them. Exit status: 0 yes, 1 no, 2 wrong words.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "figures.hpp"
#include "measured/update.hpp"
#include "memory_table.hpp"

namespace {

using namespace zstrip;

constexpr double kCyclesInAMillisecond = 125e3;
constexpr double kMiss = 56;  // by four lines at half of the processor's clock, as `zstrip bench --board pico` has it

measured::Row row_of(const std::string& line) {
  measured::Row row;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  if (row.size() != pico::figures_format().columns.size()) throw std::runtime_error("no row: " + line);
  return row;
}

void write_line(std::ostream& page, const char* what, double cycles) {
  char text[128];
  std::snprintf(text, sizeof text, "| %s | %.2f | %.1f |\n", what, cycles / 1e6, cycles / kCyclesInAMillisecond);
  page << text;
}

void write_page(const measured::Table& table) {
  std::ofstream page(std::filesystem::path(pico::kFiguresFile).replace_extension(".md"));
  page << "# The running Pico, measured\n\nWritten by `tests/measure pico`, from a run "
          "[in an emulator](../../firmware/README.md#the-pico-in-an-emulator).\n"
          "[pico.csv](pico.csv) has the same figures.\n";
  for (const measured::Row& row : table.rows) {
    const double cycles = std::stod(row[2]), waiting = std::stod(row[3]), misses = std::stod(row[4]);
    page << "\n`zstrip_" << row[0] << "`, " << row[1]
         << ", the mean of two frames. Millions of cycles at 125 MHz, and milliseconds:\n\n"
            "| A frame | cycles | ms |\n|---|--:|--:|\n";
    write_line(page, "drawing", cycles - waiting);
    write_line(page, "waiting for the panel", waiting);
    write_line(page, "**together**", cycles);
    write_line(page, "not in it: reads of the flash", misses * kMiss);
    page << "\nReads of the flash are " << row[4] << " misses of its cache. The deepest stack was " << row[5]
         << " bytes.\n";
  }
  page << R"(
`zstrip_pico_show` has its scene as constants, `zstrip_pico_player` any scene that `zstrip bake` has put into the
flash: here with one sample a pixel. `zstrip_pico_player_hot` is the player with
[hot code in RAM](../../firmware/README.md#hot-code-in-ram). The emulator counts no time for the flash. Its cache has
16 KB, two ways, 8 bytes a line. A miss takes 56 cycles: 8 clocks of an address, 4 of waiting and 16 of data, by four
lines at 62.5 MHz. Some of it passes while the panel is waited for.
)";
  if (!page.flush()) throw std::runtime_error("cannot write the page");
}

int run(const std::vector<std::string>& words) {
  const measured::Table format = pico::figures_format();
  measured::Table fresh = format;
  fresh.notes = {budget::compiler_note()};
  const bool is_exact = words.back() == "--exact";
  for (std::size_t i = 1; i < words.size() - (is_exact ? 1 : 0); ++i) fresh.rows.push_back(row_of(words[i]));
  const measured::Table recorded = measured::recorded_or_empty(pico::kFiguresFile, format);
  if (words[0] == "check") {
    if (recorded.notes != fresh.notes) {
      std::cout << "the figures are those of another compiler\n";
      return 77;
    }
    std::string lines;
    for (const measured::Row& row : fresh.rows) lines += measured::complaint(recorded, row);
    std::cout << lines;
    return lines.empty() ? 0 : 1;
  }
  const measured::Table merged = measured::merged(recorded, fresh, is_exact, words[0] == "write");
  measured::write_table(pico::kFiguresFile, merged);
  write_page(merged);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> given(words + 1, words + count);
  if (given.size() < 2 || (given[0] != "check" && given[0] != "write" && given[0] != "add")) {
    std::cerr << "zstrip_pico_record: wrong words; its first lines say which there are\n";
    return 2;
  }
  try {
    return run(given);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
