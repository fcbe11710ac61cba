// Runs another program to its end and keeps what it printed.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

struct ChildOutput {
  int exit_status = 0;  ///< 128 + signal if a signal ended it
  std::string text;     ///< standard output and standard error, in the order of arrival; the first 64 MiB
};

/// `arguments[0]` is looked for in PATH. Standard input is empty. A program that is not there, or that runs longer than
/// `limit` (it is killed then), is a failure with ExitStatus::environment.
Result<ChildOutput> run_program(const std::vector<std::string>& arguments, std::chrono::seconds limit);

}  // namespace zstrip::sim
