// The part of Arduino's SPI that sketches here use, and what some cores have for DMA.
#pragma once

#include <Arduino.h>

#ifdef TEST_OLD_CORE
#define SPI_MODE0 0x00
#define SPI_MODE3 0x03
typedef uint8_t SPIMode;
#else
typedef enum { SPI_MODE0 = 0, SPI_MODE3 = 3 } SPIMode;
#endif

struct SPISettings {
  SPISettings(uint32_t clock, BitOrder, SPIMode) : hertz(clock) {}
  uint32_t hertz;
};

// Cores have different names for it.
class TestSpi {
 public:
  void begin();
  void beginTransaction(SPISettings settings);
  void transfer(void* bytes, size_t count);
  void endTransaction();

  bool transferAsync(const void* send, void* receive, size_t count);
  bool finishedAsync();
  void abortAsync();
};
extern TestSpi SPI;
