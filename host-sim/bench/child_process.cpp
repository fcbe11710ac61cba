// posix_spawn with both output streams in one pipe, read until it closes or the time is up.
#include "bench/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

namespace zstrip::sim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxText = std::size_t{64} << 20;

// Appends what arrives until the other end closes, at most kMaxText; false when `deadline` passes first.
bool read_until_closed(int descriptor, Clock::time_point deadline, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd waiting{descriptor, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return true;
    if (count > 0 && text.size() < kMaxText) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Result<ChildOutput> run_program(const std::vector<std::string>& arguments, std::chrono::seconds limit) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Failure{ExitStatus::environment, fmt::format("cannot create a pipe: {}", std::strerror(errno))};
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);

  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) {
    close(ends[0]);
    return Failure{ExitStatus::environment, fmt::format("cannot start {}: {}", arguments[0], std::strerror(error))};
  }

  ChildOutput output;
  const Clock::time_point deadline = Clock::now() + limit;
  bool in_time = read_until_closed(ends[0], deadline, output.text);
  close(ends[0]);
  int status = 0;
  // A program may close its output and go on.
  while (in_time && waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
    in_time = Clock::now() < deadline;
  }
  if (!in_time) {
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return Failure{ExitStatus::environment, fmt::format("{} did not end within {} s", arguments[0], limit.count())};
  }
  output.exit_status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return output;
}

}  // namespace zstrip::sim
