// libgpiod 1.x (Debian 12 has 1.6): lines belong to a chip, which stays open.
#include <gpiod.h>

#include <cerrno>

#include "zstrip_hal_linux/gpio_backend.hpp"
#include "zstrip_hal_linux/release.hpp"

namespace zstrip::hal::gpio {
namespace {

using Chip = Owned<gpiod_chip, gpiod_chip_close>;  // closing releases its lines, too

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

int request_output(const std::string& path, unsigned offset, bool level, RequestPointer& request) {
  Chip chip(gpiod_chip_open(path.c_str()));
  if (chip == nullptr) return errno;
  gpiod_line* line = gpiod_chip_get_line(chip.get(), offset);
  if (line == nullptr || gpiod_line_request_output(line, "zstrip", level ? 1 : 0) != 0) return errno;
  request.reset(new Request{std::move(chip), line});
  return 0;
}

int set_level(Request& request, bool level) {
  return gpiod_line_set_value(request.line, level ? 1 : 0) == 0 ? 0 : errno;
}

}  // namespace zstrip::hal::gpio
