// Of LovyanGFX 1.2, and of M5GFX: the names that the adapter calls.
#pragma once

#include <cstdint>

namespace lgfx {

struct swap565_t {
  std::uint8_t high, low;
};

class IBus {};
class Panel_Device {};

class LGFX_Device {
 public:
  void setPanel(Panel_Device* panel) { panel_ = panel; }
  void setRotation(std::uint_fast8_t rotation);
  bool init();
  void initDMA();
  std::int32_t width() const;
  std::int32_t height() const;
  void startWrite();
  void endWrite();
  template <typename T>
  void pushImageDMA(std::int32_t x, std::int32_t y, std::int32_t w, std::int32_t h, const T* data);
  void waitDMA();

 private:
  Panel_Device* panel_ = nullptr;
};

}  // namespace lgfx
