// Of the Raspberry Pi Pico SDK 1.5 and 2: the names that the adapter calls.
#pragma once

#include "pico/stdlib.h"

enum dma_channel_transfer_size { DMA_SIZE_8, DMA_SIZE_16, DMA_SIZE_32 };
struct dma_channel_config {
  dma_channel_transfer_size size;
  uint dreq;
};
int dma_claim_unused_channel(bool required);
dma_channel_config dma_channel_get_default_config(uint channel);
void channel_config_set_transfer_data_size(dma_channel_config* config, dma_channel_transfer_size size);
void channel_config_set_dreq(dma_channel_config* config, uint dreq);
void dma_channel_configure(uint channel, const dma_channel_config* config, volatile void* to, const volatile void* from,
                           uint count, bool trigger);
bool dma_channel_is_busy(uint channel);
void dma_channel_abort(uint channel);
