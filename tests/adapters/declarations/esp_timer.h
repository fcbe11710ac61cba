// This header declares the name of ESP-IDF 5 that the program of `zstrip bake
// --project esp_idf` calls.
#pragma once

#include <cstdint>

std::int64_t esp_timer_get_time();
