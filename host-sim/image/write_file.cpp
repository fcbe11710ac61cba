// Writes files completely or not at all.
#include "image/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

#include "image/inputs.hpp"

namespace zstrip::sim {
namespace {

/// Returns the failure "'path' cannot be written", with the reason and what to do.
Failure cannot_write(const std::filesystem::path& path, int reason, const char* option) {
  const char* advice = "choose another place";
  if (reason == ENOSPC || reason == EDQUOT) advice = "free some space there, or choose another place";
  if (reason == EACCES || reason == EPERM || reason == EROFS) advice = "choose a place that you may write to";
  if (reason == ENXIO) advice = "open that stream, or choose another place";
  if (reason == ENOENT || reason == ENOTDIR) advice = "create its folder first, or choose another place";
  return {ExitStatus::output, fmt::format("cannot write '{}': {}; {} with {}", path.string(),
                                          std::generic_category().message(reason), advice, option)};
}

/// `path` is a link without a target: the target is missing, or links form a circle.
Failure cannot_follow(const std::filesystem::path& path, int reason, const char* option) {
  std::error_code ignored;
  return {
      ExitStatus::output,
      fmt::format("cannot write '{}', a symbolic link to '{}': {}; remove the link, or choose another place with {}",
                  path.string(), std::filesystem::read_symlink(path, ignored).string(),
                  std::generic_category().message(reason), option)};
}

/// Returns 0 or the error number. Always closes `file`: an error of the disk may be reported only then.
int write_and_close(int file, std::span<const std::uint8_t> content) {
  int reason = 0;
  while (!content.empty() && reason == 0) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written >= 0) {
      content = content.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      reason = errno;
    }
  }
  if (::close(file) != 0 && reason == 0) reason = errno;
  return reason;
}

/// Returns the permissions that open() would set.
mode_t default_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// Delays signals that end the program, so that no temporary file is left behind. They take effect in the destructor.
class SignalPause {
 public:
  SignalPause() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGXCPU}) ::sigaddset(&ending, signal);
    ::sigprocmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalPause() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

Result<Done> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> content, const char* option) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return cannot_write(path, EISDIR, option);
  if (Result<Done> checked = check_no_input(path, option); !checked) return checked;
  // A link is kept: its target is replaced.
  std::error_code error;
  std::filesystem::path target = std::filesystem::canonical(path, error);
  // A device; or a file without a name, such as /dev/stdout after the output's file was deleted.
  if (std::filesystem::exists(status) && (!std::filesystem::is_regular_file(status) || target.empty())) {
    const int open_file = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    const int reason = open_file < 0 ? errno : write_and_close(open_file, content);
    if (reason != 0) return cannot_write(path, reason, option);
    return Done{};
  }
  if (target.empty()) {
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))) {
      return cannot_follow(path, error.value(), option);
    }
    target = path;
  }
  const SignalPause pause;
  // Names may have up to 255 bytes, also the name of the temporary file.
  constexpr std::size_t kLongest = 240;
  const std::string name = target.filename().string().substr(0, kLongest);
  std::string temporary = (target.parent_path() / fmt::format(".{}.XXXXXX", name)).string();
  const int file = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (file < 0) return cannot_write(path, errno, option);
  int reason = ::fchmod(file, default_mode()) != 0 ? errno : 0;
  const int write_reason = write_and_close(file, content);
  if (reason == 0) reason = write_reason;
  if (reason == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
  if (reason == 0) return Done{};
  ::unlink(temporary.c_str());
  return cannot_write(path, reason, option);
}

}  // namespace zstrip::sim
