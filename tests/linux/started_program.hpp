// A program that runs beside the test, and ends with it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace zstrip::linux_window {

class StartedProgram {
 public:
  /// `words`: the program, found as by a shell, and its arguments. `variables`: NAME=VALUE, beside the test's own. What
  /// it writes to `stream`, 1 or 2, can be read here.
  StartedProgram(const std::vector<std::string>& words, const std::vector<std::string>& variables, int stream = 1);
  ~StartedProgram();
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  /// The next line, without its end. Throws std::runtime_error if there is none in 30 seconds.
  std::string read_line();
  void send(int signal) const;
  /// Its exit status; 1000 + the signal that ended it; -1 if it does not end in 30 seconds.
  int wait();

 private:
  pid_t process_ = -1;
  int output_ = -1;
};

}  // namespace zstrip::linux_window
