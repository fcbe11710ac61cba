// Exit statuses of zstrip-panel, documented in docs/linux.md. The host command uses the same numbers.
#pragma once

#include <string>

namespace zstrip::panel {

enum class ExitStatus : int {
  ok = 0,        ///< all frames were shown, or a signal or a closed window ended the program
  internal = 1,  ///< a bug
  usage = 2,     ///< the command line
  device = 3,    ///< a device that is missing, busy or not permitted
  input = 4,     ///< the scene
  budget = 5,    ///< too little memory
  output = 6,    ///< the display failed while pictures were shown, or standard output failed
};

/// `message` is one line: the thing, what is wrong with it, what to do.
struct Failure {
  ExitStatus status = ExitStatus::internal;
  std::string message;
};

}  // namespace zstrip::panel
