// Warns of parts of files that Assimp ignores without a message.
#include "import/assimp/unread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "import/ending.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {

void warn_of_unread(const std::filesystem::path& path, const FilesRead& files, SourceModel& model) {
  const std::string ending = ending_of(path);
  model.warnings.insert(model.warnings.end(), files.warnings.begin(), files.warnings.end());
  if (files.curves_and_solids > 0) {
    model.warnings.push_back(fmt::format("{} of DXF left out: only faces and straight lines are drawn",
                                         counted(files.curves_and_solids, "element")));
  }
  // In both cases Assimp guesses the material.
  std::vector<std::string> undefined;
  std::set_difference(files.materials.used.begin(), files.materials.used.end(), files.materials.defined.begin(),
                      files.materials.defined.end(), std::back_inserter(undefined));
  if (ending == ".obj" && !files.not_opened.empty()) {
    model.warnings.push_back(fmt::format("materials '{}' cannot be opened; their surfaces are drawn without them",
                                         printable(files.not_opened.front())));
  } else if (!undefined.empty()) {
    model.warnings.push_back(
        fmt::format("material '{}'{} not defined; surfaces with {} are drawn without", printable(undefined.front()),
                    undefined.size() == 1 ? " is" : fmt::format(" and {} more are", undefined.size() - 1),
                    undefined.size() == 1 ? "it" : "them"));
  }
}

}  // namespace zstrip::sim
