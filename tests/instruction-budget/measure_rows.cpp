// Measures rows again: measure ZSTRIP FIRMWARE FOLDER [--exact] [ROW...]. ZSTRIP is the command, FIRMWARE the folder of
// the programs for boards, FOLDER has instructions.csv. Exit status: 0 written, 1 why not, 2 wrong words.
#include <stdexcept>
#include <string>
#include <vector>

#include "instruction_table.hpp"
#include "measure.hpp"
#include "measured/update.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::instruction_budget;

void measure_all(const Programs& programs, const std::filesystem::path& file, const measured::Choice& choice) {
  const measured::Table recorded = measured::read_table(file, instructions_format());
  std::vector<std::string> known;
  for (const measured::Row& row : recorded.rows) known.push_back(row.front());
  check(choice, known);
  measured::Table fresh = instructions_format();
  fresh.notes = compiler_notes();
  std::size_t done = 0;
  for (const measured::Row& row : recorded.rows) {
    ++done;
    if (!choice.has(row.front())) continue;
    measured::say_progress(fresh.part, done, recorded.rows.size(), row.front());
    const auto figure = measure(case_of(row), programs);
    if (!figure) throw std::runtime_error("this machine cannot count the instructions of " + row.front());
    fresh.rows.push_back(with_figure(row, *figure));
  }
  measured::write_table(file, measured::merged(recorded, fresh, choice.exact, choice.whole()));
}

}  // namespace

int main(int count, char** words) {
  return measured::run_update(count, words, "measure ZSTRIP FIRMWARE FOLDER", 3,
                              [](const auto& before, const auto& choice) {
                                measure_all({before[0], before[1]}, before[2] + "/instructions.csv", choice);
                              });
}
