// This header declares the name of ESP-IDF 5 that the adapter of RGB panels calls.
#pragma once

#include <cstdint>

void esp_rom_delay_us(std::uint32_t microseconds);
