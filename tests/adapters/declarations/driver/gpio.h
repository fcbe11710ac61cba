// This header declares the names of ESP-IDF 5 that the program of `zstrip bake
// --project esp_idf` calls.
#pragma once

#include <cstdint>

enum gpio_num_t : int { GPIO_NUM_NC = -1 };
enum gpio_mode_t { GPIO_MODE_OUTPUT = 2 };
int gpio_set_direction(gpio_num_t pin, gpio_mode_t mode);
int gpio_set_level(gpio_num_t pin, std::uint32_t level);
