// Of FreeRTOS: the names that the adapter of esp_lcd calls.
#pragma once

#include <cstdint>

using BaseType_t = int;
using TickType_t = std::uint32_t;
inline constexpr BaseType_t pdFALSE = 0, pdTRUE = 1;
constexpr TickType_t pdMS_TO_TICKS(std::uint32_t milliseconds) { return milliseconds / 10; }
BaseType_t xPortInIsrContext();
struct StaticSemaphore_t {
  bool given;
};
