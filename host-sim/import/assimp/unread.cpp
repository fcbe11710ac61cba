// Warns of parts of files that Assimp ignores without a message.
#include "import/assimp/unread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "import/ending.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Returns the number of edges in the header of a PLY file.
std::uint64_t edges_of_ply(const std::filesystem::path& path) {
  constexpr int kMaxLines = 1000;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (int i = 0; i < kMaxLines && std::getline(file, line) && !line.starts_with("end_header"); ++i) {
    std::istringstream words(line);
    std::string element, name;
    std::uint64_t count = 0;
    if (words >> element >> name >> count && element == "element" && name == "edge") return count;
  }
  return 0;
}

}  // namespace

void warn_of_unread(const std::filesystem::path& path, const FilesRead& files, SourceModel& model) {
  const std::string ending = ending_of(path);
  model.warnings.insert(model.warnings.end(), files.warnings.begin(), files.warnings.end());
  // In both cases Assimp guesses the material.
  std::vector<std::string> undefined;
  std::set_difference(files.materials.used.begin(), files.materials.used.end(), files.materials.defined.begin(),
                      files.materials.defined.end(), std::back_inserter(undefined));
  if (ending == ".obj" && !files.not_opened.empty()) {
    model.warnings.push_back(fmt::format("materials '{}' cannot be opened; what uses them is drawn without",
                                         printable(files.not_opened.front())));
  } else if (!undefined.empty()) {
    model.warnings.push_back(
        fmt::format("material '{}'{} not defined; what uses {} is drawn without", printable(undefined.front()),
                    undefined.size() == 1 ? " is" : fmt::format(" and {} more are", undefined.size() - 1),
                    undefined.size() == 1 ? "it" : "them"));
  }
  const std::uint64_t edges = ending == ".ply" ? edges_of_ply(path) : 0;
  if (edges > 0) {
    model.warnings.push_back(
        fmt::format("{} left out: edges of PLY are not read; write faces", counted(edges, "edge")));
  }
}

}  // namespace zstrip::sim
