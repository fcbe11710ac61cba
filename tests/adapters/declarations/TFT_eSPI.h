// Of TFT_eSPI 2.5: the names that the adapter and its sketch call.
#pragma once

#include <cstdint>

class TFT_eSPI {
 public:
  void init(std::uint8_t tab_colour = 0);
  bool initDMA(bool controls_select = false);
  void setRotation(std::uint8_t rotation);
  std::int16_t width();
  std::int16_t height();
  void setSwapBytes(bool swap);
  void startWrite();
  void endWrite();
  void pushImageDMA(std::int32_t x, std::int32_t y, std::int32_t w, std::int32_t h, std::uint16_t* data,
                    std::uint16_t* buffer = nullptr);
  void dmaWait();
  bool DMA_Enabled = false;
};
