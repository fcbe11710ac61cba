// This header declares the name of FreeRTOS that the program of `zstrip bake
// --project esp_idf` calls. FreeRTOS.h must be included before
// it.
#pragma once

void vTaskDelay(TickType_t ticks);
