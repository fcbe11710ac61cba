// Of Arduino_GFX 1.4: the names that the adapter and its sketch call.
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

class Arduino_DataBus {};
class Arduino_HWSPI : public Arduino_DataBus {
 public:
  explicit Arduino_HWSPI(std::int8_t dc, std::int8_t cs = -1);
};

class Arduino_ST7789 : public Arduino_GFX {
 public:
  Arduino_ST7789(Arduino_DataBus* bus, std::int8_t rst = -1, std::uint8_t r = 0, bool ips = false, std::int16_t w = 240,
                 std::int16_t h = 320, std::uint8_t col_offset1 = 0, std::uint8_t row_offset1 = 0,
                 std::uint8_t col_offset2 = 0, std::uint8_t row_offset2 = 0);
  bool begin(std::int32_t speed = -1) override;
  void draw16bitBeRGBBitmap(std::int16_t x, std::int16_t y, std::uint16_t* bitmap, std::int16_t w,
                            std::int16_t h) override;
  void flush(bool force = false) override;
};
