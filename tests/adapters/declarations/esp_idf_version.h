// Of ESP-IDF: the names that the adapter calls.
#pragma once

#ifndef ESP_IDF_VERSION_PATCH
#define ESP_IDF_VERSION_PATCH 1
#endif
#define ESP_IDF_VERSION_VAL(major, minor, patch) ((major) << 16 | (minor) << 8 | (patch))
#define ESP_IDF_VERSION ESP_IDF_VERSION_VAL(5, 0, ESP_IDF_VERSION_PATCH)
