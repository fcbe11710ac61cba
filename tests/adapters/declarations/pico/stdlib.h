// Of the Raspberry Pi Pico SDK 1.5 and 2: the names that the adapter and its program call.
#pragma once

#include <cstdint>

using uint = unsigned int;
enum gpio_function_t { GPIO_FUNC_SPI = 1 };
inline constexpr bool GPIO_OUT = true;
void gpio_init(uint pin);
void gpio_set_dir(uint pin, bool out);
void gpio_set_function(uint pin, gpio_function_t function);
void gpio_put(uint pin, bool high);
bool stdio_init_all();
struct absolute_time_t {
  std::uint64_t microseconds;
};
absolute_time_t get_absolute_time();
std::uint32_t to_ms_since_boot(absolute_time_t time);
void sleep_us(std::uint64_t microseconds);
std::uint32_t time_us_32();
void tight_loop_contents();
