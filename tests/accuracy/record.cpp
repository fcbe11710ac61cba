// Records what `zstrip accuracy` measured in docs/measured: record FRESH [--exact] [SCENE...]. FRESH is the folder of
// its results.
#include <fstream>
#include <stdexcept>

#include "measured/update.hpp"

namespace {

using namespace zstrip::measured;
namespace fs = std::filesystem;

Column column_of(const std::string& name) {
  if (name == "scene" || name == "cause" || name == "settings") return {name, std::nullopt};
  if (name == "m0" || name == "m3" || name == "m4f") return {name, kInstructions};
  if (name == "program_bytes") return {name, kFlash};
  if (name.ends_with("_bytes")) return {name, kExact};
  // Six digits are written; the truth's last bits may differ among compilers.
  return {name, Tolerance{.share = 1e-3, .at_least = 1e-6}};
}

Table format_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw std::runtime_error("cannot read " + file.string());
  Table format{.part = "accuracy"};
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    format.columns.push_back(column_of(line.substr(at, comma - at)));
    at = comma + 1;
  }
  return format;
}

void record(const fs::path& fresh, const fs::path& recorded, const Choice& choice) {
  const Table format = format_of(fresh);
  write_table(recorded,
              merged(recorded_or_empty(recorded, format), read_table(fresh, format), choice.exact, choice.whole()));
}

}  // namespace

int main(int count, char** words) {
  return run_update(count, words, "record FRESH", 1, [](const std::vector<std::string>& before, const Choice& choice) {
    const fs::path fresh = before[0], folder = ZSTRIP_MEASURED;
    record(fresh / "accuracy.csv", folder / "accuracy.csv", choice);
    record(fresh / "causes.csv", folder / "accuracy-causes.csv", choice);
  });
}
