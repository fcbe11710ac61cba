// Both cores of a Raspberry Pi Pico draw, each the next strip when it is free. For the core of Earle Philhower, which
// runs loop1() on the second core; elsewhere start a task there that calls second.serve() for ever.
// 60 KB of RAM.
#include <SPI.h>
#include <zstrip.h>
#include <zstrip_arduino.h>

// The panel's pins in addition to SPI clock and data. Without a select pin: kSelect = -1, and .mode = SPI_MODE3 below.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;
constexpr std::uint32_t kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

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

constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
// The budget of each core, half of 60 KB. It counts two strip buffers for each core; both cores together use only
// three.
constexpr zstrip::Budget kBudget{.bytes = 30 * 1024, .strip_buffers = 2};
using Renderer = zstrip::FixedRenderer<kScene, kView, kBudget, zstrip::effect::unclipped>;
Renderer renderer, renderer_of_second;
zstrip::hal::SecondCore second(renderer_of_second);
alignas(4) std::byte pixels[3][Renderer::kStripBytes];

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
  if (!zstrip::orbit(camera, {0, 0, 0}, 4 << 16, turn, 65536 * 3 / 16)) return;
  turn += 512;
  // Each core begins the frame with its own renderer, both at once.
  const auto begin = [&camera] { return renderer_of_second.begin_frame(camera); };
  second.start(begin);
  const zstrip::Status begun = renderer.begin_frame(camera);
  if (!begun) {
    Serial.println(zstrip::message(begun.error));
    while (!second.is_done()) delay(1);
    return;
  }
  const auto shown = zstrip::hal::present(renderer, second, panel, {Renderer::kPlan.strips, Renderer::kPlan.strip_rows},
                                          {pixels[0], pixels[1], pixels[2]}, waiting);
  if (!shown) Serial.println(shown.draw ? zstrip::hal::message(shown.display) : zstrip::message(shown.draw.error));
}

void loop1() { second.serve(); }
