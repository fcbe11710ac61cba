// Writes messages to stderr.
#include "cli/print.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "text/step_report.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

void print_line(std::string_view kind, std::string_view message) {
  hide_step();
  // If writing fails, the exit status still reports the failure.
  write_text(stderr, fmt::format("zstrip: {}{}\n", kind, printable(message)));
}

}  // namespace

void print_warning(std::string_view message) { print_line("warning: ", message); }

int print_failure(const Failure& failure) {
  print_line("", failure.message);
  return static_cast<int>(failure.status);
}

}  // namespace zstrip::sim
