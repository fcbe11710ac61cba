// Of the Raspberry Pi Pico SDK 1.5 and 2: the names that the adapter calls.
#pragma once

#include <cstdint>

using uint = unsigned int;
void gpio_put(uint pin, bool high);
void sleep_us(std::uint64_t microseconds);
std::uint32_t time_us_32();
