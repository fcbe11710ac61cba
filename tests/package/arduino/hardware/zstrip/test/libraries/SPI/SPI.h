// The part of Arduino's SPI that sketches here use, and what some cores have for DMA.
#pragma once

#include <Arduino.h>

typedef enum { SPI_MODE0 = 0, SPI_MODE3 = 3 } SPIMode;

struct SPISettings {
  SPISettings(uint32_t clock, BitOrder, SPIMode) : hertz(clock) {}
  uint32_t hertz;
};

class SPIClass {
 public:
  void begin();
  void beginTransaction(SPISettings settings);
  void transfer(void* bytes, size_t count);
  void endTransaction();

  bool transferAsync(const void* send, void* receive, size_t count);
  bool finishedAsync();
  void abortAsync();
};
extern SPIClass SPI;
