// The functions of libgpiod that zstrip needs. Its releases 1 and 2 have different interfaces; CMake compiles
// gpio_libgpiod1.cpp or gpio_libgpiod2.cpp, which implement these functions. They return 0 or errno.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace zstrip::hal::gpio {

struct LineInfo {
  std::string name;      ///< empty: no name
  std::string consumer;  ///< the program that uses it, by its own name; may be empty
  bool used = false;
};

/// Reads all lines of the chip at `path`, by offset.
int read_lines(const std::string& path, std::vector<LineInfo>& lines);

struct Request;
struct ReleaseRequest {
  void operator()(Request* request) const;
};
using RequestPointer = std::unique_ptr<Request, ReleaseRequest>;

/// Makes a line of the chip at `path` an output that starts at `level`.
int request_output(const std::string& path, unsigned offset, bool level, RequestPointer& request);

/// Makes a line of the chip at `path` an input.
int request_input(const std::string& path, unsigned offset, RequestPointer& request);

int set_level(Request& request, bool level);
int get_level(Request& request, bool& level);

}  // namespace zstrip::hal::gpio
