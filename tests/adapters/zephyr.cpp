// A stand-in for a display driver of Zephyr.
#include "libraries.hpp"
#include "zephyr_display.hpp"

struct device {
  display_pixel_format format;
};

namespace {

using namespace zstrip::adapters_test;

template <display_pixel_format format>
struct ZephyrParts {
  device driver{screen().fault == Fault::format ? PIXEL_FORMAT_RGB_888 : format};
  adapters::ZephyrDisplay adapter{&driver};
};

}  // namespace

bool device_is_ready(const device*) { return screen().fault != Fault::start; }
void display_get_capabilities(const device* driver, display_capabilities* capabilities) {
  *capabilities = {kWidth, kHeight, driver->format};
}
int display_write(const device* driver, std::uint16_t x, std::uint16_t y, const display_buffer_descriptor* pixels,
                  const void* bytes) {
  if (screen().fault == Fault::write) return -5;
  const bool last = x + pixels->width == kWidth && y + pixels->height == kHeight;
  if (pixels->frame_incomplete == last) screen().complain("the frame's end is another");
  if (pixels->pitch != pixels->width || pixels->buf_size != 2U * pixels->width * pixels->height) {
    screen().complain("the buffer is described wrongly");
  }
  screen().draw({x, y, pixels->width, pixels->height}, bytes,
                driver->format == PIXEL_FORMAT_RGB_565 ? First::low : First::high);
  return 0;
}

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_zephyr() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565>>>();
}
std::unique_ptr<panel::AnyDisplay> open_zephyr_swapped() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565X>>>();
}
}  // namespace zstrip::adapters_test
