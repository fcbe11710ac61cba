// Pins and transfers, as a panel sees them, and Arduino's functions for them.
#include "board.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

#include <Arduino.h>
#include <SPI.h>
#undef abs
#undef max
#undef min
#undef round

namespace zstrip::package {
namespace {

constexpr sim::Glass kGlass{.width = 240, .height = 240, .inverted = true};

sim::Nanoseconds cycle(std::uint32_t hertz) { return sim::Nanoseconds(1'000'000'000 / (hertz == 0 ? 1 : hertz)); }

}  // namespace

Board::Board() : panel_(sim::kSt7789Part, kGlass) { panel_.elapse(sim::Nanoseconds(std::chrono::milliseconds(10))); }

void Board::complain(const char* what) {
  if (fault_.empty()) fault_ = what;
}

unsigned long Board::milliseconds() const {
  return static_cast<unsigned long>(std::chrono::duration_cast<std::chrono::milliseconds>(panel_.now()).count());
}

void Board::set_pin(unsigned pin, bool high) {
  if (!sending_.empty()) complain("a pin changes during a transfer");
  const bool was = level(pin);
  levels_ = (levels_ & ~(1U << pin)) | (high ? 1U << pin : 0U);
  if (pin == kReset && was != high) panel_.set_reset(high);
}

void Board::begin_transaction(std::uint32_t hertz) {
  if (in_transaction_) complain("a transaction within another");
  if (hertz_ != hertz) panel_.clocked_at(cycle(hertz));
  hertz_ = hertz;
  in_transaction_ = true;
}

void Board::end_transaction() {
  if (!sending_.empty()) complain("a transaction ends during a transfer");
  if (!level(kSelect)) complain("a transaction ends while the panel is selected");
  in_transaction_ = false;
}

void Board::send(std::span<const std::byte> bytes) {
  if (!in_transaction_) complain("a transfer outside of a transaction");
  if (level(kSelect)) complain("a transfer while the panel is not selected");
  const unsigned needed = 1U << kDataCommand | 1U << kSelect | 1U << kReset;
  if ((outputs_ & needed) != needed) complain("a pin is no output");
  panel_.elapse(8 * bytes.size() * cycle(hertz_));
  panel_.receive(level(kDataCommand) ? sim::Wire::data : sim::Wire::command, bytes);
}

void Board::start_sending(std::span<const std::byte> bytes) {
  if (!sending_.empty()) complain("a transfer during another");
  sending_ = bytes;
  as_given_.assign(bytes.begin(), bytes.end());
}

bool Board::has_sent() {
  if (sending_.empty()) return true;
  if (!std::equal(sending_.begin(), sending_.end(), as_given_.begin())) complain("bytes change during their transfer");
  const std::span<const std::byte> bytes = sending_;
  sending_ = {};
  send(bytes);
  return false;  // has gone over now: the next question finds it done
}

std::string Board::fault() const {
  if (!fault_.empty()) return fault_;
  if (!said_.empty()) return "the sketch says: " + said_;
  if (!panel_.complaints().empty()) return panel_.complaints().front();
  return panel_.darkness();
}

Board& board() {
  static Board only;
  return only;
}

}  // namespace zstrip::package

using zstrip::package::board;

void pinMode(pin_size_t pin, PinMode mode) {
  if (mode == OUTPUT) board().set_output(pin);
}
void digitalWrite(pin_size_t pin, PinStatus level) { board().set_pin(pin, level == HIGH); }
// A stick that is held to the right and halfway up.
int analogRead(pin_size_t pin) { return pin == A0 ? 1023 : 200; }
void delay(unsigned long milliseconds) { board().pass_time(std::chrono::milliseconds(milliseconds)); }
void delayMicroseconds(unsigned int microseconds) {
  // In truth, too: a sketch may wait for the second core's thread.
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  board().pass_time(std::chrono::microseconds(microseconds));
}
unsigned long millis() { return board().milliseconds(); }
extern "C" char* itoa(int value, char* text, int) {
  std::sprintf(text, "%d", value);
  return text;
}

SerialPort Serial;
void SerialPort::begin(unsigned long) {}
size_t SerialPort::println(const char* text) {
  board().say(text);
  return std::strlen(text);
}

TestSpi SPI;
void TestSpi::begin() {}
void TestSpi::beginTransaction(SPISettings settings) { board().begin_transaction(settings.hertz); }
void TestSpi::transfer(void* bytes, size_t count) {
  const std::span all(static_cast<std::byte*>(bytes), count);
  board().send(all);
  std::fill(all.begin(), all.end(), std::byte{0xA5});  // what comes back
}
void TestSpi::endTransaction() { board().end_transaction(); }
bool TestSpi::transferAsync(const void* send, void*, size_t count) {
  board().start_sending({static_cast<const std::byte*>(send), count});
  return true;
}
bool TestSpi::finishedAsync() { return board().has_sent(); }
void TestSpi::abortAsync() {}
