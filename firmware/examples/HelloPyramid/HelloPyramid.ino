// Hello, pyramid: a pyramid rotates on a panel of 240x240 pixels, ST7789, on SPI. 20 KB of RAM.
#include <SPI.h>
#include <zstrip.h>
#include <zstrip_arduino.h>

// The panel's pins in addition to SPI clock and data. Without a select pin: kSelect = -1, and .mode = SPI_MODE3 below.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;
constexpr std::uint32_t kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

// The scene: corners between -32767 and 32767 with a colour each, and which of them make a triangle.
constexpr zstrip::Position kPositions[]{
    {0, 32767, 0}, {-32767, -32767, 32767}, {32767, -32767, 32767}, {32767, -32767, -32767}, {-32767, -32767, -32767}};
constexpr zstrip::Colour kColours[]{
    {255, 255, 255, 255}, {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
constexpr zstrip::Triangle kTriangles[]{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 3}, {1, 3, 2}};
constexpr zstrip::Mesh kMeshes[]{{.positions = kPositions,
                                  .normals = {},
                                  .colours = kColours,
                                  .texcoords = {},
                                  .triangles = kTriangles,
                                  .meshlets = {}}};
constexpr zstrip::Material kMaterials[]{{.lit = false}};
constexpr zstrip::Instance kInstances[]{{.mesh = 0, .material = 0}};
constexpr zstrip::Scene kScene{
    .meshes = kMeshes, .materials = kMaterials, .textures = {}, .instances = kInstances, .lights = {}};
static_assert(zstrip::validate(kScene));

// The compiler plans strips that fit, with their pixels, into the bytes of kBudget.
constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
constexpr zstrip::Budget kBudget{.bytes = 20 * 1024, .strip_buffers = 1};
zstrip::FixedRenderer<kScene, kView, kBudget, zstrip::effect::unclipped> renderer;
alignas(4) std::byte pixels[renderer.kStripBytes];

zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = kDataCommand, .select = kSelect}, kHertz);
zstrip::hal::St7789 panel(bus, waiting);

void setup() {
  Serial.begin(115200);
  bus.start();
  zstrip::hal::ArduinoPin reset(kReset);
  (void)zstrip::hal::reset_panel(reset, waiting);
  const zstrip::hal::Error error = panel.start();
  if (error != zstrip::hal::Error::none) Serial.println(zstrip::hal::message(error));
}

void loop() {
  static zstrip::Angle turn = 0;  // 65536 is a full one
  zstrip::Camera camera;
  // The camera stands at a distance of 4 (16.16) and looks from above: 3/16 of a turn from the pole.
  if (!zstrip::orbit(camera, {0, 0, 0}, 4 << 16, turn, 65536 * 3 / 16)) return;
  turn += 512;
  const zstrip::Status begun = renderer.begin_frame(camera);
  if (!begun) {
    Serial.println(zstrip::message(begun.error));
    return;
  }
  const auto shown =
      zstrip::hal::present(renderer, panel, {renderer.kPlan.strips, renderer.kPlan.strip_rows}, {pixels, {}});
  if (!shown) Serial.println(shown.draw ? zstrip::hal::message(shown.display) : zstrip::message(shown.draw.error));
}
