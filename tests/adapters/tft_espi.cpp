// A stand-in for TFT_eSPI.
#include "tft_espi.hpp"

#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

// Sketches leave it set: the adapter must not rely on it.
bool swaps_bytes, writing;

struct TftEspiParts {
  TFT_eSPI tft;
  adapters::TftEspi adapter{tft};
};

// A sketch that has started DMA itself.
struct TftEspiWithDmaParts : TftEspiParts {
  TftEspiWithDmaParts() { tft.initDMA(); }
};

}  // namespace

void TFT_eSPI::init(std::uint8_t) { swaps_bytes = true, writing = false; }
bool TFT_eSPI::initDMA(bool) {
  if (DMA_Enabled) return false;  // as of a bus without DMA
  return DMA_Enabled = screen().fault != Fault::start;
}
void TFT_eSPI::setRotation(std::uint8_t) {}
std::int16_t TFT_eSPI::width() { return kWidth; }
std::int16_t TFT_eSPI::height() { return kHeight; }
void TFT_eSPI::setSwapBytes(bool swap) { swaps_bytes = swap; }
void TFT_eSPI::startWrite() { writing = true; }
void TFT_eSPI::endWrite() {
  if (screen().busy()) screen().complain("endWrite() during a transfer");
  writing = false;
}
void TFT_eSPI::pushImageDMA(std::int32_t x, std::int32_t y, std::int32_t w, std::int32_t h, std::uint16_t* data,
                            std::uint16_t* buffer) {
  if (!writing) screen().complain("pushImageDMA() without startWrite()");
  if (buffer != nullptr) screen().complain("a copy of what need not be copied");
  screen().begin(area_of(x, y, w, h), data, swaps_bytes ? First::low : First::high);
}
void TFT_eSPI::dmaWait() { screen().end(); }

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_tft_espi() { return std::make_unique<Opened<TftEspiParts>>(); }
std::unique_ptr<panel::AnyDisplay> open_tft_espi_with_dma() { return std::make_unique<Opened<TftEspiWithDmaParts>>(); }
}  // namespace zstrip::adapters_test
