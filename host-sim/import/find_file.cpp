// Finds files that a model names: exporters write paths of their own machine.
#include "import/find_file.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Returns the entry `name` of a folder, or the entry whose name differs only in upper and lower case, because other
/// systems ignore the case; empty if there is none. Of several entries the first in the alphabet, so that every run
/// chooses the same.
std::filesystem::path find_entry(const std::filesystem::path& folder, const std::filesystem::path& name) {
  std::error_code ignored;
  if (std::filesystem::exists(folder / name, ignored)) return folder / name;
  const std::string wanted = lower(name.string());
  std::filesystem::path found;
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, ignored);
  for (; !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    std::filesystem::path other = entry->path().filename();
    if (lower(other.string()) == wanted && (found.empty() || other < found)) found = std::move(other);
  }
  return found.empty() ? found : folder / found;
}

/// Returns the path below a folder, each of its names in any case; empty if there is none.
std::filesystem::path find_below(std::filesystem::path folder, std::span<const std::filesystem::path> names) {
  for (const std::filesystem::path& name : names) {
    folder = find_entry(folder, name);
    if (folder.empty()) break;
  }
  return folder;
}

}  // namespace

std::filesystem::path find_file(const std::filesystem::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path path(name);
  std::error_code ignored;
  if (std::filesystem::exists(folder / path, ignored)) return folder / path;
  // Exporters write folders of their own machine: "C:/Users/me/model/textures/a.png" may be "textures/a.png" here.
  const std::vector<std::filesystem::path> names(path.begin(), path.end());
  for (std::size_t first = 0; first < names.size(); ++first) {
    std::filesystem::path found = find_below(folder, std::span(names).subspan(first));
    const bool is_whole = first == 0 && !found.empty();
    if (is_whole || std::filesystem::is_regular_file(found, ignored)) return found;
  }
  return folder / path;
}

}  // namespace zstrip::sim
