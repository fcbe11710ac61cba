// As CubeMX writes it: the HAL of the family.
#pragma once

#include "stm32f4xx_hal.h"

#define LCD_DC_GPIO_Port GPIOA
#define LCD_DC_Pin GPIO_PIN_0
#define LCD_CS_GPIO_Port GPIOA
#define LCD_CS_Pin GPIO_PIN_1
#define LCD_RST_GPIO_Port GPIOA
#define LCD_RST_Pin GPIO_PIN_2
#ifdef __cplusplus
extern "C"
#endif
    void
    Error_Handler(void);
