// The files that this process has read, which it must not overwrite.
#include "image/inputs.hpp"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace zstrip::sim {
namespace {

struct Inputs {
  std::mutex mutex;
  std::set<std::filesystem::path> paths;  ///< canonical
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

}  // namespace

void remember_input(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path name = std::filesystem::canonical(path, error);
  if (error) return;
  const std::scoped_lock lock(inputs().mutex);
  inputs().paths.insert(std::move(name));
}

Result<Done> check_no_input(const std::filesystem::path& path, const char* option) {
  std::error_code error;
  const std::filesystem::path name = std::filesystem::canonical(path, error);
  const std::scoped_lock lock(inputs().mutex);
  if (error || !inputs().paths.contains(name)) return Done{};
  return Failure{ExitStatus::usage,
                 fmt::format("'{}' is read by this command and is not replaced; choose another place with {}",
                             path.string(), option)};
}

}  // namespace zstrip::sim
