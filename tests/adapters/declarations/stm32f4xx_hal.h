// Of the HAL of STM32Cube for F4, release 1.8: the names that the adapter calls.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define __IO volatile

typedef enum { HAL_OK = 0x00U, HAL_ERROR = 0x01U, HAL_BUSY = 0x02U, HAL_TIMEOUT = 0x03U } HAL_StatusTypeDef;

typedef struct {
  __IO uint32_t ODR;
} GPIO_TypeDef;
typedef enum { GPIO_PIN_RESET = 0, GPIO_PIN_SET } GPIO_PinState;
#define GPIO_PIN_0 ((uint16_t)0x0001)
#define GPIO_PIN_1 ((uint16_t)0x0002)
#define GPIO_PIN_2 ((uint16_t)0x0004)
#define GPIOA ((GPIO_TypeDef*)0x40020000U)
void HAL_GPIO_WritePin(GPIO_TypeDef* GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState);

typedef enum {
  HAL_SPI_STATE_RESET = 0x00U,
  HAL_SPI_STATE_READY = 0x01U,
  HAL_SPI_STATE_BUSY = 0x02U,
  HAL_SPI_STATE_BUSY_TX = 0x03U
} HAL_SPI_StateTypeDef;
#define HAL_SPI_ERROR_NONE (0x00000000U)
#define HAL_SPI_ERROR_DMA (0x00000010U)
typedef struct __SPI_HandleTypeDef {
  __IO HAL_SPI_StateTypeDef State;
  __IO uint32_t ErrorCode;
} SPI_HandleTypeDef;
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef* hspi, const uint8_t* pData, uint16_t Size, uint32_t Timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef* hspi, const uint8_t* pData, uint16_t Size);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef* hspi);
HAL_SPI_StateTypeDef HAL_SPI_GetState(const SPI_HandleTypeDef* hspi);
uint32_t HAL_SPI_GetError(const SPI_HandleTypeDef* hspi);

void HAL_Delay(uint32_t Delay);
uint32_t HAL_GetTick(void);

#ifdef __cplusplus
}
#endif
