// A stand-in for Arduino_GFX.
#include "arduino_gfx.hpp"

#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

struct ArduinoGfxParts {
  Arduino_HWSPI bus{8, 10};
  Arduino_ST7789 panel{&bus};
  adapters::ArduinoGfx adapter{panel};
};

}  // namespace

Arduino_HWSPI::Arduino_HWSPI(std::int8_t, std::int8_t) {}
Arduino_ST7789::Arduino_ST7789(Arduino_DataBus*, std::int8_t, std::uint8_t, bool, std::int16_t, std::int16_t,
                               std::uint8_t, std::uint8_t, std::uint8_t, std::uint8_t) {}
bool Arduino_ST7789::begin(std::int32_t) { return screen().fault != Fault::start; }
void Arduino_ST7789::draw16bitBeRGBBitmap(std::int16_t x, std::int16_t y, std::uint16_t* bitmap, std::int16_t w,
                                          std::int16_t h) {
  screen().draw(area_of(x, y, w, h), bitmap, First::high);
}
void Arduino_ST7789::flush(bool) {}
std::int16_t Arduino_GFX::width() const { return kWidth; }
std::int16_t Arduino_GFX::height() const { return kHeight; }

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_arduino_gfx() { return std::make_unique<Opened<ArduinoGfxParts>>(); }
}  // namespace zstrip::adapters_test
