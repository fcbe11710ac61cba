// A program that runs beside the test, and ends with it.
#include "started_program.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace zstrip::linux_window {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 30s;

}  // namespace

StartedProgram::StartedProgram(const std::vector<std::string>& words, const std::vector<std::string>& variables,
                               int stream) {
  int pipe_ends[2];
  if (::pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const std::string& variable : variables) ::putenv(const_cast<char*>(variable.c_str()));
    ::dup2(pipe_ends[1], stream);
    ::close(pipe_ends[0]);
    ::close(pipe_ends[1]);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(pipe_ends[1]);
  output_ = pipe_ends[0];
  if (process_ < 0) throw std::runtime_error("no process");
}

StartedProgram::~StartedProgram() {
  ::close(output_);
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

std::string StartedProgram::read_line() {
  std::string line;
  for (;;) {
    pollfd waiting{output_, POLLIN, 0};
    char letter = 0;
    if (::poll(&waiting, 1, std::chrono::milliseconds(kPatience).count()) <= 0 || ::read(output_, &letter, 1) != 1)
      throw std::runtime_error("no line, but '" + line + "'");
    if (letter == '\n') return line;
    line += letter;
  }
}

void StartedProgram::send(int signal) const { ::kill(process_, signal); }

int StartedProgram::wait() {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  while (::waitpid(process_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) return -1;
    std::this_thread::sleep_for(5ms);
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

}  // namespace zstrip::linux_window
