// A temporary file for another program. The destructor deletes it.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace zstrip::sim {

class TemporaryFile {
 public:
  /// `suffix`: with its dot.
  TemporaryFile(std::string_view prefix, std::string_view suffix) {
    static std::atomic<unsigned> number{0};
    path_ = std::filesystem::temp_directory_path() / fmt::format("{}_{}_{}{}", prefix, getpid(), number++, suffix);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace zstrip::sim
