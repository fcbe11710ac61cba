// Measures programs and writes what the tests compare with: measure BINARIES FOLDER [--exact] [PROGRAM...]. BINARIES
// has the programs, FOLDER gets memory.csv and memory.md. Exit status: 0 written, 1 why not, 2 wrong words.
#include <fstream>
#include <set>
#include <stdexcept>

#include "measured/update.hpp"
#include "memory_table.hpp"

namespace {

using namespace zstrip;

void measure_all(const std::filesystem::path& binaries, const std::filesystem::path& folder,
                 const measured::Choice& choice) {
  std::vector<std::string> known;
  for (const budget::Target& target : budget::targets()) known.emplace_back(target.program);
  check(choice, known);
  measured::Table fresh = budget::memory_format();
  fresh.notes = {budget::compiler_note()};
  std::size_t done = 0;
  for (const budget::Target& target : budget::targets()) {
    ++done;
    if (!choice.has(target.program)) continue;
    measured::say_progress(fresh.part, done, budget::targets().size(),
                           std::string(target.program) + ", " + target.scene);
    fresh.rows.push_back(budget::row_of(budget::measure(target, binaries)));
  }
  const measured::Table recorded = measured::recorded_or_empty(folder / "memory.csv", budget::memory_format());
  const measured::Table merged = measured::merged(recorded, fresh, choice.exact, choice.whole());
  const std::string page = budget::memory_page(merged);
  measured::write_table(folder / "memory.csv", merged);
  std::ofstream out(folder / "memory.md");
  out << page << std::flush;
  if (!out) throw std::runtime_error("cannot write " + (folder / "memory.md").string());
}

}  // namespace

int main(int count, char** words) {
  return measured::run_update(count, words, "measure BINARIES FOLDER", 2, [](const auto& before, const auto& choice) {
    measure_all(before[0], before[1], choice);
  });
}
