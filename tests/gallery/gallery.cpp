// Counts the frames of the programs of project/. `tests/measure gallery` and a test run it; effects/cost/part.hpp has
// the words.
#include <stdexcept>

#include "effects/cost/machines.hpp"
#include "effects/cost/part.hpp"
#include "gallery_table.hpp"
#include "memory_table.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::gallery;

std::vector<measured::Row> measure(const std::string& scene, const std::filesystem::path& build,
                                   const effects_cost::Names& machines) {
  std::vector<measured::Row> rows;
  std::string pixels;
  for (const char* const kilobytes : kKilobytes) {
    for (const std::string& machine : machines) {
      for (const char* const preset : kPresets) {
        const std::filesystem::path program = build / (machine + "_" + preset) / (scene + "_" + kilobytes);
        const Counted counted = parse_counted(effects_cost::printed_on(machine, program, scene));
        if (pixels.empty()) pixels = counted.crc32;
        if (counted.crc32 != pixels) throw std::runtime_error(program.string() + " draws other pixels than the others");
        rows.push_back(row_of(scene, machine, preset, kilobytes, counted, effects_cost::flash_of(program)));
      }
    }
  }
  return rows;
}

}  // namespace

int main(int count, char** words) {
  effects_cost::Part part{
      .format = gallery_format(),
      .notes = {budget::compiler_note("-O2 (`speed`), or with -Os and link time optimisation (`size`)")},
      .names = {std::begin(kScenes), std::end(kScenes)},
      .usual = {"train"},  // is counted soonest
      .programs =
          [](const std::string& scene) {
            std::set<std::string> programs;
            for (const char* const kilobytes : kKilobytes) programs.insert(scene + "_" + kilobytes);
            return programs;
          },
      .measure = measure,
      .page = gallery_page,
      .check = {}};
  return run_part(count, words, part);
}
