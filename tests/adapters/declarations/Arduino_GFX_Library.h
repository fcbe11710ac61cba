// Of Arduino_GFX 1.4: the names that the adapter calls.
#pragma once

#include <cstdint>

class Arduino_GFX {
 public:
  virtual ~Arduino_GFX() = default;
  virtual bool begin(std::int32_t speed = -1) = 0;
  virtual void draw16bitBeRGBBitmap(std::int16_t x, std::int16_t y, std::uint16_t* bitmap, std::int16_t w,
                                    std::int16_t h) = 0;
  virtual void flush(bool force = false) = 0;
  std::int16_t width() const;
  std::int16_t height() const;
};
