// Finds files that a model names: exporters write paths of their own machine.
#include "import/find_file.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Returns `path`, or the file of its folder whose name differs only in upper and lower case, because other systems
/// ignore the case. Of several files the first in the alphabet, so that every run chooses the same.
std::filesystem::path find_in_any_case(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return path;
  const std::string wanted = lower(path.filename().string());
  std::filesystem::path found;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::filesystem::directory_iterator entry(folder, ignored);
  for (; !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    std::filesystem::path name = entry->path().filename();
    if (lower(name.string()) == wanted && (found.empty() || name < found)) found = std::move(name);
  }
  return found.empty() ? path : path.parent_path() / found;
}

}  // namespace

std::filesystem::path find_file(const std::filesystem::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::filesystem::path as_given = find_in_any_case(folder / name);
  std::error_code ignored;
  if (std::filesystem::exists(as_given, ignored)) return as_given;
  const std::filesystem::path beside = find_in_any_case(folder / std::filesystem::path(name).filename());
  return std::filesystem::is_regular_file(beside, ignored) ? beside : as_given;
}

}  // namespace zstrip::sim
