// A board whose pins and clock are some registers.
#include <Arduino.h>

static volatile uint32_t& register_at(uint32_t offset) {
  return *reinterpret_cast<volatile uint32_t*>(0x40020000 + offset);
}

void pinMode(pin_size_t pin, PinMode mode) { register_at(pin) = mode; }
void digitalWrite(pin_size_t pin, PinStatus level) { register_at(0x100 + 4U * pin) = level; }
int analogRead(pin_size_t pin) { return static_cast<int>(register_at(0x180 + 4U * pin) & 1023U); }
unsigned long millis() { return register_at(0x200); }
void delay(unsigned long milliseconds) {
  for (const unsigned long start = millis(); millis() - start < milliseconds;) {
  }
}
void delayMicroseconds(unsigned int microseconds) {
  for (const uint32_t start = register_at(0x204); register_at(0x204) - start < microseconds;) {
  }
}

SerialPort Serial;
void SerialPort::begin(unsigned long baud) { register_at(0x300) = baud; }
size_t SerialPort::println(const char* text) {
  size_t count = 0;
  for (; text[count] != 0; ++count) register_at(0x304) = static_cast<uint8_t>(text[count]);
  return count;
}

// Of a C library, what programs here need.
extern "C" {
void* memcpy(void* to, const void* from, size_t count) {
  for (size_t i = 0; i < count; ++i) static_cast<char*>(to)[i] = static_cast<const char*>(from)[i];
  return to;
}
void* memmove(void* to, const void* from, size_t count) {
  if (to < from) return memcpy(to, from, count);
  for (size_t i = count; i-- > 0;) static_cast<char*>(to)[i] = static_cast<const char*>(from)[i];
  return to;
}
void* memset(void* to, int value, size_t count) {
  for (size_t i = 0; i < count; ++i) static_cast<char*>(to)[i] = static_cast<char>(value);
  return to;
}
char* itoa(int value, char* text, int base) {
  char* end = text;
  for (int rest = value; rest >= base; rest /= base) ++end;
  end[1] = 0;
  for (char* digit = end; digit >= text; value /= base) *digit-- = static_cast<char>('0' + value % base);
  return text;
}
}

int main() {
  setup();
  for (;;) loop();
}
