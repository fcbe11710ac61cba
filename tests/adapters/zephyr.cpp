// A stand-in for a display driver of Zephyr. zephyr_4_2.cpp includes this with the names of that release, and
// ZEPHYR_4_2: all of it is in a namespace, so that one program has both.
#include <span>

#include "libraries.hpp"

#ifdef ZEPHYR_4_2
namespace zephyr_4_2 {
#else
namespace zephyr_4_4 {
#endif
// clang-format off: after what it includes
#include "zephyr_display.hpp"
// clang-format on

struct device {
  display_pixel_format format;  // as it reports
  zstrip::adapters_test::First first;
};

namespace {

using namespace zstrip::adapters_test;

template <display_pixel_format format, First first, zstrip::hal::DisplayFormat... told>
struct ZephyrParts {
  device driver{screen().fault == Fault::format ? PIXEL_FORMAT_RGB_888 : format, first};
  adapters::ZephyrDisplay adapter{&driver, told...};
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
  screen().draw({x, y, pixels->width, pixels->height}, bytes, driver->first);
  return 0;
}

}  // namespace zephyr_4_2 or zephyr_4_4

namespace zstrip::adapters_test {
#ifdef ZEPHYR_4_2
using namespace zephyr_4_2;
std::unique_ptr<panel::AnyDisplay> open_zephyr_4_2() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_BGR_565, First::low>>>();
}
std::unique_ptr<panel::AnyDisplay> open_zephyr_4_2_swapped() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565, First::high>>>();
}
#else
using namespace zephyr_4_4;
std::unique_ptr<panel::AnyDisplay> open_zephyr() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565, First::low>>>();
}
std::unique_ptr<panel::AnyDisplay> open_zephyr_swapped() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565X, First::high>>>();
}
std::unique_ptr<panel::AnyDisplay> open_zephyr_mislabelled() {
  return std::make_unique<Opened<ZephyrParts<PIXEL_FORMAT_RGB_565, First::high, hal::DisplayFormat::rgb565_swapped>>>();
}
#endif
}  // namespace zstrip::adapters_test
