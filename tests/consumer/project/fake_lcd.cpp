// An RGB565 panel for the example of docs/displays.md: takes its bytes from "DMA" late, as a board does, and judges at
// the end of the program what has arrived.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr std::size_t kWidth = 320, kHeight = 240;

class Lcd {
 public:
  ~Lcd() {
    // The triangle has turned once: its last frame is nearly the first. Red, the high byte first, on black.
    const std::size_t centre = 2 * (kHeight / 2 * kWidth + kWidth / 2);
    if (frames_ != 64 || busy_ != 0) fail("not 64 whole frames");
    if (memory_[centre] != 0xF8 || memory_[centre + 1] != 0x00) fail("the centre is not red");
    if (memory_[0] != 0 || memory_[1] != 0) fail("the corner is not black");
  }

  void set_data(bool data) {
    need_idle();
    data_ = data;
  }

  void take(const std::uint8_t* bytes, std::size_t count) {
    need_idle();
    for (std::size_t i = 0; i < count; ++i) data_ ? take_data(bytes[i]) : take_command(bytes[i]);
  }

  void start_dma(const std::uint8_t* bytes, std::size_t count) {
    need_idle();
    source_ = bytes;
    count_ = count;
    sum_ = checksum();
    busy_ = 3;
  }

  // Every call is some time later; the bytes go over at the last moment.
  bool busy() {
    if (busy_ > 0 && --busy_ == 0) {
      if (checksum() != sum_) fail("the pixels changed during their transfer");
      take(source_, count_);
    }
    return busy_ > 0;
  }

 private:
  [[noreturn]] static void fail(const char* what) {
    std::fprintf(stderr, "panel: %s\n", what);
    std::_Exit(1);
  }

  std::uint32_t checksum() const {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum = sum * 31 + source_[i];
    return sum;
  }

  void need_idle() const {
    if (busy_ > 0) fail("used during a transfer");
  }

  void take_command(std::uint8_t command) {
    if (command != 0x2A && command != 0x2B && command != 0x2C) fail("unknown command");
    command_ = command;
    parameters_ = 0;
    if (command == 0x2C) x_ = columns_[0], y_ = rows_[0];
  }

  void take_data(std::uint8_t byte) {
    if (command_ == 0x2C) return take_pixel_byte(byte);
    std::array<std::size_t, 2>& range = command_ == 0x2A ? columns_ : rows_;
    if (parameters_ > 3) fail("too many parameters");
    std::size_t& edge = range[parameters_ / 2];
    edge = parameters_ % 2 == 0 ? std::size_t{byte} << 8 : edge | byte;
    ++parameters_;
  }

  void take_pixel_byte(std::uint8_t byte) {
    if (x_ >= kWidth || y_ >= kHeight || y_ > rows_[1]) fail("pixels beyond the window");
    memory_[2 * (y_ * kWidth + x_) + half_] = byte;
    half_ ^= 1U;
    if (half_ != 0 || ++x_ <= columns_[1]) return;
    x_ = columns_[0];
    if (++y_ == kHeight) ++frames_;
  }

  std::array<std::uint8_t, 2 * kWidth * kHeight> memory_{};
  std::array<std::size_t, 2> columns_{}, rows_{};
  std::size_t x_ = 0, y_ = 0, half_ = 0, parameters_ = 0;
  std::uint8_t command_ = 0;
  bool data_ = false;
  const std::uint8_t* source_ = nullptr;
  std::size_t count_ = 0;
  std::uint32_t sum_ = 0;
  int busy_ = 0;
  int frames_ = 0;
};

Lcd lcd;

}  // namespace

extern "C" {
void lcd_start();
void lcd_data_line(bool high);
void lcd_send(const void* bytes, std::size_t count);
void lcd_send_by_dma(const void* bytes, std::size_t count);
bool lcd_busy();
void lcd_stop_dma();
std::uint32_t milliseconds();
}

void lcd_start() {}
void lcd_data_line(bool high) { lcd.set_data(high); }
void lcd_send(const void* bytes, std::size_t count) { lcd.take(static_cast<const std::uint8_t*>(bytes), count); }
void lcd_send_by_dma(const void* bytes, std::size_t count) {
  lcd.start_dma(static_cast<const std::uint8_t*>(bytes), count);
}
bool lcd_busy() { return lcd.busy(); }
void lcd_stop_dma() { std::abort(); }
std::uint32_t milliseconds() { return 0; }
