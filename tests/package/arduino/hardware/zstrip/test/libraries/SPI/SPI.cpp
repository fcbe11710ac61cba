// An SPI controller that is one register.
#include "SPI.h"

static volatile uint8_t& data() { return *reinterpret_cast<volatile uint8_t*>(0x40013000); }

SPIClass SPI;
void SPIClass::begin() {}
void SPIClass::beginTransaction(SPISettings) {}
void SPIClass::transfer(void* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    data() = static_cast<uint8_t*>(bytes)[i];
    static_cast<uint8_t*>(bytes)[i] = data();
  }
}
void SPIClass::endTransaction() {}
bool SPIClass::transferAsync(const void* send, void*, size_t count) {
  for (size_t i = 0; i < count; ++i) data() = static_cast<const uint8_t*>(send)[i];
  return true;
}
bool SPIClass::finishedAsync() { return true; }
void SPIClass::abortAsync() {}
