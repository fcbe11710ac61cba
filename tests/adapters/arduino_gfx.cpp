// A stand-in for Arduino_GFX.
#include "arduino_gfx.hpp"

#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

struct Panel final : Arduino_GFX {
  bool begin(std::int32_t) override { return screen().fault != Fault::start; }
  void draw16bitBeRGBBitmap(std::int16_t x, std::int16_t y, std::uint16_t* bitmap, std::int16_t w,
                            std::int16_t h) override {
    screen().draw(area_of(x, y, w, h), bitmap, First::high);
  }
  void flush(bool) override {}
};

struct ArduinoGfxParts {
  Panel panel;
  adapters::ArduinoGfx adapter{panel};
};

}  // namespace

std::int16_t Arduino_GFX::width() const { return kWidth; }
std::int16_t Arduino_GFX::height() const { return kHeight; }

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_arduino_gfx() { return std::make_unique<Opened<ArduinoGfxParts>>(); }
}  // namespace zstrip::adapters_test
