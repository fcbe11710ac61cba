// Of the Raspberry Pi Pico SDK 1.5 and 2: the names that the adapter and its program call.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pico/stdlib.h"

struct spi_inst_t;
extern spi_inst_t* const spi0;
uint spi_init(spi_inst_t* spi, uint hertz);
struct spi_hw_t {
  volatile std::uint32_t dr;
};
spi_hw_t* spi_get_hw(spi_inst_t* spi);
uint spi_get_dreq(spi_inst_t* spi, bool is_tx);
bool spi_is_busy(const spi_inst_t* spi);
int spi_write_blocking(spi_inst_t* spi, const std::uint8_t* bytes, std::size_t count);
