// libgpiod 1.x (Debian 12 has 1.6): lines belong to a chip, which stays open.
#include <gpiod.h>

#include <cerrno>

#include "zstrip_hal_linux/gpio_backend.hpp"
#include "zstrip_hal_linux/release.hpp"

namespace zstrip::hal::gpio {
namespace {

using Chip = Owned<gpiod_chip, gpiod_chip_close>;  // closing releases its lines, too

constexpr const char* kConsumer = "zstrip";

std::string text(const char* name) { return name != nullptr ? name : ""; }

}  // namespace

struct Request {
  Chip chip;
  gpiod_line* line;
};

void ReleaseRequest::operator()(Request* request) const { delete request; }

int read_lines(const std::string& path, std::vector<LineInfo>& lines) {
  const Chip chip(gpiod_chip_open(path.c_str()));
  if (chip == nullptr) return errno;
  for (unsigned offset = 0; offset < gpiod_chip_num_lines(chip.get()); ++offset) {
    gpiod_line* line = gpiod_chip_get_line(chip.get(), offset);
    if (line == nullptr) return errno;
    lines.push_back({text(gpiod_line_name(line)), text(gpiod_line_consumer(line)), gpiod_line_is_used(line)});
  }
  return 0;
}

namespace {

/// `ask` requests the line and returns 0, or else sets errno.
template <class Ask>
int request_line(const std::string& path, unsigned offset, RequestPointer& request, Ask ask) {
  Chip chip(gpiod_chip_open(path.c_str()));
  if (chip == nullptr) return errno;
  gpiod_line* line = gpiod_chip_get_line(chip.get(), offset);
  if (line == nullptr || ask(line) != 0) return errno;
  request.reset(new Request{std::move(chip), line});
  return 0;
}

}  // namespace

int request_output(const std::string& path, unsigned offset, bool level, RequestPointer& request) {
  return request_line(path, offset, request,
                      [level](gpiod_line* line) { return gpiod_line_request_output(line, kConsumer, level ? 1 : 0); });
}

int request_input(const std::string& path, unsigned offset, RequestPointer& request) {
  return request_line(path, offset, request,
                      [](gpiod_line* line) { return gpiod_line_request_input(line, kConsumer); });
}

int set_level(Request& request, bool level) {
  return gpiod_line_set_value(request.line, level ? 1 : 0) == 0 ? 0 : errno;
}

int get_level(Request& request, bool& level) {
  const int value = gpiod_line_get_value(request.line);
  if (value < 0) return errno;
  level = value != 0;
  return 0;
}

}  // namespace zstrip::hal::gpio
