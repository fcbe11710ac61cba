// Parses, runs, and reports every failure as a line of text and a status.
#include "cli/command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/print.hpp"
#include "cli/usage_error.hpp"
#include "cli/version.hpp"
#include "result.hpp"

namespace zstrip::sim {
namespace {

/// Opens a descriptor on which writing fails for each closed standard stream. Otherwise the next file that is opened,
/// such as a picture, would become the stream, and messages would be written into it. For outputs it is a socket
/// without a peer, because /dev/stdout can then not be opened either; that of a file could.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // Both get the lowest free number: this one.
    if (stream == STDIN_FILENO || ::socket(AF_UNIX, SOCK_DGRAM, 0) < 0) ::open("/dev/null", O_RDONLY);
  }
}

int parse_and_run(int argc, char** argv, void (*add_commands)(CLI::App& app, int& exit_code)) {
  CLI::App app{"zstrip renders 3D scenes as devices with kilobytes of RAM would: strip by strip, in fixed point.",
               "zstrip"};
  app.set_version_flag("--version", std::string("zstrip ") + kVersion);
  app.footer(
      "Examples:\n  zstrip scenes\n  zstrip render teapot -o out --frames 8\n\n"
      "'zstrip COMMAND --help' tells more. Exit status: 0 done, 1 internal error, 2 command line,\n"
      "3 environment, 4 input file, 5 too little memory allowed, 6 output cannot be written.");
  int exit_code = 0;
  add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);  // --help, --version
    } else {
      return print_failure({ExitStatus::usage, usage_error(app, error)});
    }
  } catch (const std::invalid_argument& error) {
    // CLI11 gives the value of a flag, as in --dither=strong, to std::stoll.
    if (std::string_view(error.what()) != "stoll") throw;
    return print_failure({ExitStatus::usage,
                          "an option that is on or off has a value that is neither true nor false; leave the value "
                          "out, as in --dither"});
  }
  if (app.get_subcommands().empty() && app.count("--version") + app.count("--help") == 0) {
    return print_failure({ExitStatus::usage, "a command is missing; see 'zstrip --help'"});
  }
  // Writing can also fail later, when buffers are flushed.
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout) {
    return print_failure({ExitStatus::output, "cannot write to standard output; is it closed, or the disk full?"});
  }
  return exit_code;
}

}  // namespace

int run_command_line(int argc, char** argv, void (*add_commands)(CLI::App& app, int& exit_code)) {
  keep_standard_streams();
  // A limit on file sizes is then an error of write(), and is reported like one.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return parse_and_run(argc, argv, add_commands);
  } catch (const std::bad_alloc&) {
    return print_failure(
        {ExitStatus::environment, "this machine has too little memory for this; use a smaller model or size"});
  } catch (const std::exception& error) {
    return print_failure({ExitStatus::internal, fmt::format("internal error: {}", error.what())});
  }
}

}  // namespace zstrip::sim
