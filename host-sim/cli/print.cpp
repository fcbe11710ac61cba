// What the command says on stderr.
#include "cli/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace zstrip::sim {
namespace {

void print_line(std::string_view kind, std::string_view message) {
  std::string line(message);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  fmt::print(stderr, "zstrip: {}{}\n", kind, line);
}

}  // namespace

void print_warning(std::string_view message) { print_line("warning: ", message); }

int print_failure(const Failure& failure) {
  print_line("", failure.message);
  return static_cast<int>(failure.status);
}

}  // namespace zstrip::sim
