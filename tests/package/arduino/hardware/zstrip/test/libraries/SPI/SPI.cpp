// An SPI controller that is one register.
#include "SPI.h"

static volatile uint8_t& data() { return *reinterpret_cast<volatile uint8_t*>(0x40013000); }

TestSpi SPI;
void TestSpi::begin() {}
void TestSpi::beginTransaction(SPISettings) {}
void TestSpi::transfer(void* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    data() = static_cast<uint8_t*>(bytes)[i];
    static_cast<uint8_t*>(bytes)[i] = data();
  }
}
void TestSpi::endTransaction() {}
bool TestSpi::transferAsync(const void* send, void*, size_t count) {
  for (size_t i = 0; i < count; ++i) data() = static_cast<const uint8_t*>(send)[i];
  return true;
}
bool TestSpi::finishedAsync() { return true; }
void TestSpi::abortAsync() {}
