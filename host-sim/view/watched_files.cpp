// Detects that a file of the scene was saved again.
#include "view/watched_files.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <system_error>
#include <vector>

#include "render/stage.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 2000;         // read from the folder: a home folder may have many
constexpr std::uintmax_t kMaxBytes = 64'000'000;  // size of a file that is searched for names

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  std::size_t entries = 0;
  for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && at != end && entries < kMaxEntries; at.increment(error), ++entries) {
    std::error_code unknown;
    if (at->is_regular_file(unknown)) files.push_back(at->path());
  }
  return files;
}

std::string bytes_of(const fs::path& path) {
  std::error_code error;
  if (fs::file_size(path, error) > kMaxBytes || error) return {};
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool names(const std::string& bytes, const fs::path& path) {
  const std::string name = path.filename().string();
  return std::search(bytes.begin(), bytes.end(), std::boyer_moore_horspool_searcher(name.begin(), name.end())) !=
         bytes.end();
}

}  // namespace

WatchedFiles::WatchedFiles(const std::string& scene) {
  if (kind_of_scene(scene) == SceneKind::built_in) return;
  std::vector<fs::path> others = files_below(fs::path(scene).parent_path() / ".");
  std::vector<fs::path> searched{scene};
  while (!searched.empty()) {
    const fs::path path = std::move(searched.back());
    searched.pop_back();
    std::error_code error;
    fs::file_time_type time = fs::last_write_time(path, error);
    if (error) time = fs::file_time_type::min();  // it may come back
    if (!times_.emplace(path.lexically_normal(), time).second) continue;
    const std::string bytes = bytes_of(path);
    const auto named = std::stable_partition(others.begin(), others.end(),
                                             [&](const fs::path& other) { return !names(bytes, other); });
    searched.insert(searched.end(), std::move_iterator(named), std::move_iterator(others.end()));
    others.erase(named, others.end());
  }
}

bool WatchedFiles::changed() {
  bool any = false;
  for (auto& [path, time] : times_) {
    std::error_code error;
    const fs::file_time_type now = fs::last_write_time(path, error);
    if (error || now == time) continue;
    time = now;
    any = true;
  }
  return any;
}

}  // namespace zstrip::sim
