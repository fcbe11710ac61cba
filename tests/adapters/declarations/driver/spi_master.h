// This header declares the names of ESP-IDF 5 that the program of `zstrip bake
// --project esp_idf` calls.
#pragma once

#include "../esp_lcd_panel_io.h"

enum spi_host_device_t { SPI2_HOST = 1 };
inline constexpr int SPI_DMA_CH_AUTO = 3;
struct spi_bus_config_t {
  int mosi_io_num, miso_io_num, sclk_io_num, quadwp_io_num, quadhd_io_num;
  int max_transfer_sz;
};
esp_err_t spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t* bus, int channel);
