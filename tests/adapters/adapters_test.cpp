// Every adapter shows what is drawn, leaves strips that are on their way alone, and tells what its library tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "libraries.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::adapters_test {

Screen& screen() {
  static Screen only;
  return only;
}

namespace {

constexpr Position kPositions[]{
    {0, 32767, 0}, {-32767, -32767, 32767}, {32767, -32767, 32767}, {32767, -32767, -32767}, {-32767, -32767, -32767}};
constexpr Colour kColours[]{
    {255, 255, 255, 255}, {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
constexpr Triangle kTriangles[]{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 3}, {1, 3, 2}};
constexpr Mesh kMeshes[]{{.positions = kPositions,
                          .normals = {},
                          .colours = kColours,
                          .texcoords = {},
                          .triangles = kTriangles,
                          .meshlets = {}}};
constexpr Material kMaterials[]{{.lit = false}};
constexpr Instance kInstances[]{{.mesh = 0, .material = 0}};
constexpr Scene kPyramid{
    .meshes = kMeshes, .materials = kMaterials, .textures = {}, .instances = kInstances, .lights = {}};
constexpr Effects kEffects = effects_of(kPyramid, Camera{});

struct Strips {
  const char* name;
  std::uint16_t rows, columns;
  bool two_buffers;
};
constexpr Strips kStrips[] = {{"Rows", 7, kWidth, false},
                              {"RowsTwoBuffers", 7, kWidth, true},
                              {"Tiles", 10, 16, false},
                              {"TilesTwoBuffers", 10, 16, true}};

/// A turn of the pyramid, by zstrip::hal::present.
hal::PresentResult<Status> present_on(panel::AnyDisplay& display, Angle turn, const Strips& strips) {
  const View view{display.width(), display.height(), static_cast<PixelFormat>(display.format())};
  const PlanResult planned =
      plan(count(kPyramid), view, kEffects, {.strip_rows = strips.rows, .strip_columns = strips.columns});
  EXPECT_TRUE(planned.status) << message(planned.status.error);
  std::vector<std::uint64_t> arena(planned.plan.bytes() / 8 + 1);
  // Longer than the frame: a transfer may go on after a time-out.
  static std::array<std::uint64_t, kWidth * kHeight / 4 + 1> first, second;
  const std::size_t bytes = planned.plan.strip_pixel_bytes(view);
  Camera camera;
  EXPECT_TRUE(orbit(camera, {0, 0, 0}, 4 << 16, turn, 65536 * 3 / 16));
  Renderer<kEffects> renderer;
  EXPECT_TRUE(renderer.begin_frame(kPyramid, camera, view, planned.plan, std::as_writable_bytes(std::span(arena))));
  const auto result = hal::present(renderer, display, {planned.plan.strips, strips.rows, strips.columns},
                                   {std::as_writable_bytes(std::span(first)).first(bytes),
                                    std::as_writable_bytes(std::span(second)).first(strips.two_buffers ? bytes : 0)});
  screen().look();
  return result;
}

/// A display with functions that may be called by pointer, of plain memory.
class Memory final : public panel::DisplayAdapter<Memory> {
 public:
  auto& display() { return framebuffer_; }
  const std::vector<std::uint16_t>& colours() const { return colours_; }

 private:
  std::vector<std::uint16_t> colours_ = std::vector<std::uint16_t>(kWidth * kHeight);
  hal::Framebuffer framebuffer_{std::as_writable_bytes(std::span(colours_)),
                                {kWidth, kHeight, hal::DisplayFormat::rgb565}};
};

std::vector<std::uint16_t> drawn_to_memory(Angle turn) {
  Memory memory;
  EXPECT_TRUE(present_on(memory, turn, {"", kHeight, kWidth, false}));
  EXPECT_LT(std::ranges::count(memory.colours(), memory.colours().front()), kWidth * kHeight * 9 / 10) << "no picture";
  return memory.colours();
}

struct Told {
  Fault fault;
  hal::Error started, shown;
};
struct Library {
  const char* name;
  Open open;
  bool by_dma;
  std::vector<Told> told;
};

void PrintTo(const Library& library, std::ostream* out) { *out << library.name; }

const Library kLibraries[] = {
    {"TftEspi", open_tft_espi, true, {{Fault::start, hal::Error::bus, hal::Error::bus}}},
    {"TftEspiWithDmaStarted", open_tft_espi_with_dma, true, {}},
    {"LovyanGfx", open_lovyangfx, true, {{Fault::start, hal::Error::bus, hal::Error::bus}}},
    {"ArduinoGfx", open_arduino_gfx, false, {{Fault::start, hal::Error::bus, hal::Error::bus}}},
    {"EspLcd",
     open_esp_lcd,
     true,
     {{Fault::start, hal::Error::bus, hal::Error::bus},
      {Fault::write, hal::Error::none, hal::Error::bus},
      {Fault::transfer, hal::Error::none, hal::Error::timeout}}},
    {"EspLcdDsi",
     open_esp_lcd_dsi,
     false,
     {{Fault::start, hal::Error::bus, hal::Error::bus}, {Fault::write, hal::Error::none, hal::Error::bus}}},
    {"EspLcdDsiByDma",
     open_esp_lcd_dsi_by_dma,
     true,
     {{Fault::start, hal::Error::bus, hal::Error::bus},
      {Fault::write, hal::Error::none, hal::Error::bus},
      {Fault::transfer, hal::Error::none, hal::Error::timeout}}},
    {"EspLcdRgbFramebuffer", open_esp_lcd_rgb_framebuffer, false, {{Fault::write, hal::Error::none, hal::Error::bus}}},
    {"Pico",
     open_pico,
     true,
     {{Fault::start, hal::Error::bus, hal::Error::bus}, {Fault::transfer, hal::Error::none, hal::Error::timeout}}},
    {"Stm32Hal",
     open_stm32,
     false,
     {{Fault::start, hal::Error::timeout, hal::Error::timeout}, {Fault::write, hal::Error::none, hal::Error::bus}}},
    {"Stm32HalDma",
     open_stm32_dma,
     true,
     {{Fault::start, hal::Error::timeout, hal::Error::timeout},
      {Fault::format, hal::Error::none, hal::Error::bus},  // the handle's error of DMA
      {Fault::write, hal::Error::none, hal::Error::bus},
      {Fault::transfer, hal::Error::none, hal::Error::timeout}}},
    {"Lvgl", open_lvgl, false, {{Fault::format, hal::Error::framebuffer, hal::Error::framebuffer}}},
    {"Zephyr",
     open_zephyr,
     false,
     {{Fault::start, hal::Error::bus, hal::Error::strip_layout},  // its size is not known either
      {Fault::format, hal::Error::configuration, hal::Error::configuration},
      {Fault::write, hal::Error::none, hal::Error::bus}}},
    {"ZephyrSwapped", open_zephyr_swapped, false, {}},
    {"ZephyrMislabelled", open_zephyr_mislabelled, false, {}},
    {"Zephyr4_2", open_zephyr_4_2, false, {}},
    {"Zephyr4_2Swapped", open_zephyr_4_2_swapped, false, {}},
#ifdef ADAPTERS_SDL2
    {"Sdl2", open_sdl2, false, {{Fault::start, hal::Error::configuration, hal::Error::configuration}}},
#endif
};

class Adapters : public testing::TestWithParam<Library> {
 protected:
  Adapters() { screen() = {}; }
};
INSTANTIATE_TEST_SUITE_P(All, Adapters, testing::ValuesIn(kLibraries),
                         [](const auto& library) { return std::string(library.param.name); });

TEST_P(Adapters, ShowWhatIsDrawnToMemory) {
  for (const Strips& strips : kStrips) {
    SCOPED_TRACE(strips.name);
    screen() = {};
    const auto display = GetParam().open();
    EXPECT_EQ(screen().started, hal::Error::none);
    for (const Angle turn : {Angle{1000}, Angle{20000}}) {
      const auto shown = present_on(*display, turn, strips);
      EXPECT_TRUE(shown) << hal::message(shown.display) << " in strip " << shown.strip;
      EXPECT_EQ(screen().colours, drawn_to_memory(turn));
    }
    EXPECT_EQ(screen().complaint, "");
    EXPECT_FALSE(screen().busy());
  }
}

TEST_P(Adapters, TellWhatTheLibraryTells) {
  for (const Told& told : GetParam().told) {
    SCOPED_TRACE(static_cast<int>(told.fault));
    screen() = {};
    const bool at_start = told.started != hal::Error::none;
    if (at_start) screen().fault = told.fault;
    const auto display = GetParam().open();
    EXPECT_EQ(screen().started, told.started);
    screen().fault = told.fault;
    if (display->width() == 0) {
      EXPECT_NE(display->begin_frame(), hal::Error::none);
      continue;
    }
    EXPECT_EQ(present_on(*display, 1000, kStrips[1]).display, told.shown);
    if (at_start) continue;
    // While a transfer goes on no frame begins; then the next one shows right.
    if (screen().busy()) {
      EXPECT_EQ(display->begin_frame(), told.shown);
    }
    screen().fault = Fault::none;
    EXPECT_TRUE(present_on(*display, 20000, kStrips[1]));
    EXPECT_EQ(screen().colours, drawn_to_memory(20000));
    EXPECT_EQ(screen().complaint, "");
  }
}

TEST_P(Adapters, RefuseWhatIsNoPartOfTheDisplay) {
  const auto display = GetParam().open();
  std::vector<std::uint16_t> pixels(kWidth * 2);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(pixels));
  ASSERT_EQ(display->begin_frame(), hal::Error::none);
  EXPECT_EQ(display->write({1, 0, kWidth, 1}, bytes), hal::Error::area);
  EXPECT_EQ(display->write({0, kHeight, 1, 1}, bytes), hal::Error::area);
  EXPECT_EQ(display->write({0, 0, 0, 1}, bytes), hal::Error::area);
  EXPECT_EQ(display->write({0, 0, kWidth, 2}, bytes.first(bytes.size() - 1)), hal::Error::pixels_too_small);
  EXPECT_EQ(display->wait(), hal::Error::none);
  EXPECT_EQ(display->end_frame(), hal::Error::none);
}

// The stand-ins see what ShowWhatIsDrawnToMemory is for: strips that are drawn into while they are on their way.
TEST_P(Adapters, SendByDmaOrCopy) {
  const bool by_dma = GetParam().by_dma;
  const auto display = GetParam().open();
  alignas(8) std::array<std::byte, 2 * kWidth> pixels{};
  ASSERT_EQ(display->begin_frame(), hal::Error::none);
  ASSERT_EQ(display->write({0, 0, kWidth, 1}, pixels), hal::Error::none);
  EXPECT_EQ(screen().busy(), by_dma);
  pixels[5] = std::byte{1};
  EXPECT_EQ(display->wait(), hal::Error::none);
  EXPECT_EQ(display->end_frame(), hal::Error::none);
  EXPECT_FALSE(screen().busy());
  EXPECT_EQ(screen().complaint, by_dma ? "bytes change during their transfer" : "");
  screen().look();
  if (!by_dma) {
    EXPECT_EQ(screen().colours[2], 0);
  }
}

}  // namespace
}  // namespace zstrip::adapters_test
