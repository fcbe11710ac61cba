// libgpiod 2.x (Debian 13 has 2.2): a request takes settings for its lines; the chip may be closed afterwards.
#include <gpiod.h>

#include <cerrno>

#include "zstrip_hal_linux/gpio_backend.hpp"
#include "zstrip_hal_linux/release.hpp"

namespace zstrip::hal::gpio {
namespace {

using Chip = Owned<gpiod_chip, gpiod_chip_close>;
using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using Line = Owned<gpiod_line_info, gpiod_line_info_free>;
using Settings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;
using LineRequest = Owned<gpiod_line_request, gpiod_line_request_release>;

gpiod_line_value value(bool level) { return level ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE; }

std::string text(const char* name) { return name != nullptr ? name : ""; }

}  // namespace

struct Request {
  LineRequest line;
  unsigned offset;
};

void ReleaseRequest::operator()(Request* request) const { delete request; }

int read_lines(const std::string& path, std::vector<LineInfo>& lines) {
  const Chip chip(gpiod_chip_open(path.c_str()));
  if (chip == nullptr) return errno;
  const ChipInfo info(gpiod_chip_get_info(chip.get()));
  if (info == nullptr) return errno;
  for (unsigned offset = 0; offset < gpiod_chip_info_get_num_lines(info.get()); ++offset) {
    const Line line(gpiod_chip_get_line_info(chip.get(), offset));
    if (line == nullptr) return errno;
    lines.push_back({text(gpiod_line_info_get_name(line.get())), text(gpiod_line_info_get_consumer(line.get())),
                     gpiod_line_info_is_used(line.get())});
  }
  return 0;
}

namespace {

/// `set` makes the settings of the line and returns 0, or else sets errno.
template <class Set>
int request_line(const std::string& path, unsigned offset, RequestPointer& request, Set set) {
  const Chip chip(gpiod_chip_open(path.c_str()));
  if (chip == nullptr) return errno;
  const Settings settings(gpiod_line_settings_new());
  const LineConfig lines(gpiod_line_config_new());
  const RequestConfig config(gpiod_request_config_new());
  if (settings == nullptr || lines == nullptr || config == nullptr) return ENOMEM;
  gpiod_request_config_set_consumer(config.get(), "zstrip");
  if (set(settings.get()) != 0 || gpiod_line_config_add_line_settings(lines.get(), &offset, 1, settings.get()) != 0) {
    return errno;
  }
  LineRequest line(gpiod_chip_request_lines(chip.get(), config.get(), lines.get()));
  if (line == nullptr) return errno;
  request.reset(new Request{std::move(line), offset});
  return 0;
}

}  // namespace

int request_output(const std::string& path, unsigned offset, bool level, RequestPointer& request) {
  return request_line(path, offset, request, [level](gpiod_line_settings* settings) {
    const int refused = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
    return refused != 0 ? refused : gpiod_line_settings_set_output_value(settings, value(level));
  });
}

int request_input(const std::string& path, unsigned offset, RequestPointer& request) {
  return request_line(path, offset, request, [](gpiod_line_settings* settings) {
    return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
  });
}

int set_level(Request& request, bool level) {
  return gpiod_line_request_set_value(request.line.get(), request.offset, value(level)) == 0 ? 0 : errno;
}

int get_level(Request& request, bool& level) {
  const gpiod_line_value found = gpiod_line_request_get_value(request.line.get(), request.offset);
  if (found == GPIOD_LINE_VALUE_ERROR) return errno;
  level = found == GPIOD_LINE_VALUE_ACTIVE;
  return 0;
}

}  // namespace zstrip::hal::gpio
