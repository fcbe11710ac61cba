// Reads complete input files; only regular files, so that a name like /dev/zero or a FIFO never blocks.
#include "import/read_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "image/inputs.hpp"

namespace zstrip::sim {
namespace {

/// First bytes of the pointer that Git LFS stores in place of a large file.
constexpr std::string_view kPointer = "version https://git-lfs.github.com/spec/";

}  // namespace

std::string advice_on_address(const std::string& name) {
  if (name.find("://") == std::string::npos) return "";
  return fmt::format("; download it first: curl -LO '{}'", name);
}

Result<Done> check_readable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    return Failure{ExitStatus::input, "does not exist" + advice_on_address(path.string())};
  }
  if (error) return Failure{ExitStatus::input, "cannot be read: " + error.message()};
  if (std::filesystem::is_directory(status)) return Failure{ExitStatus::input, "is a folder; name a file in it"};
  if (!std::filesystem::is_regular_file(status)) return Failure{ExitStatus::input, "is not a regular file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Failure{ExitStatus::input, "cannot be read: " + std::generic_category().message(errno)};
  std::string begin(kPointer.size(), '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == kPointer) {
    return Failure{ExitStatus::input, "is a Git LFS pointer, not the file; fetch that by 'git lfs pull'"};
  }
  return Done{};
}

Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path, std::size_t limit) {
  const Result<Done> readable = check_readable(path);
  if (!readable) return readable.failure();
  // No stream iterators: their buffer throws if the system reports an error.
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  constexpr std::size_t kBlock = 65536;
  while (file && bytes.size() <= limit) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kBlock);
    file.read(reinterpret_cast<char*>(bytes.data() + before), kBlock);
    bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (bytes.size() > limit) return Failure{ExitStatus::input, fmt::format("has more than {} MB", limit >> 20)};
  if (file.bad()) return Failure{ExitStatus::input, "cannot be read to its end"};
  remember_input(path);
  return bytes;
}

}  // namespace zstrip::sim
