// A stand-in for LovyanGFX.
#include "lovyangfx.hpp"

#include <type_traits>

#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

bool device_writes;

struct LovyanGfxParts {
  lgfx::LGFX_Device device;
  adapters::LovyanGfx adapter{device};
};

}  // namespace

namespace lgfx {

bool LGFX_Device::init() { return screen().fault != Fault::start; }
void LGFX_Device::initDMA() { device_writes = false; }
std::int32_t LGFX_Device::width() const { return kWidth; }
std::int32_t LGFX_Device::height() const { return kHeight; }
void LGFX_Device::startWrite() { device_writes = true; }
void LGFX_Device::endWrite() {
  if (screen().busy()) screen().complain("endWrite() during a transfer");
  device_writes = false;
}
template <typename T>
void LGFX_Device::pushImageDMA(std::int32_t x, std::int32_t y, std::int32_t w, std::int32_t h, const T* data) {
  static_assert(std::is_same_v<T, swap565_t>, "another format");
  if (!device_writes) screen().complain("pushImageDMA() without startWrite()");
  screen().begin(area_of(x, y, w, h), data, First::high);
}
template void LGFX_Device::pushImageDMA(std::int32_t x, std::int32_t y, std::int32_t w, std::int32_t h,
                                        const swap565_t* data);
void LGFX_Device::setRotation(std::uint_fast8_t) {}
void LGFX_Device::waitDMA() { screen().end(); }

}  // namespace lgfx

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_lovyangfx() { return std::make_unique<Opened<LovyanGfxParts>>(); }
}  // namespace zstrip::adapters_test
