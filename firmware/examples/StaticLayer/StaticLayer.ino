// A static layer: three pyramids that do not move are drawn once and stored, compressed, with their depth. Each frame
// draws only the one that moves among them, and sends only the changed pixels. 66 KB of RAM.
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

// Rows of a transform, 16.16: size on the diagonal, place at the end.
constexpr zstrip::Instance at(zstrip::Fixed x, zstrip::Fixed z, zstrip::Fixed size) {
  return {.mesh = 0, .material = 0, .transform = {{{size, 0, 0, x}, {0, size, 0, 0}, {0, 0, size, z}}}};
}
constexpr zstrip::Instance kStanding[]{at(-65536, 0, 45000), at(65536, 0, 45000), at(0, -150000, 65536)};
constexpr zstrip::Scene kBackground{.meshes = kMeshes,
                                    .materials = kMaterials,
                                    .textures = {},
                                    .instances = kStanding,
                                    .lights = {},
                                    .background = {24, 40, 72, 255}};
zstrip::Instance moving[]{at(0, 0, 20000)};
constexpr zstrip::Scene kMoving{
    .meshes = kMeshes, .materials = kMaterials, .textures = {}, .instances = moving, .lights = {}};

// A layer stores pixels with the low byte first; their bytes are swapped on the way to the panel.
constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565};
constexpr zstrip::Effects kEffects = zstrip::effects_of(kBackground, zstrip::Camera{});
constexpr std::uint32_t kDepthPool = 16 * 1024, kColourPool = 24 * 1024;  // zstrip plan measures what a scene takes
constexpr zstrip::Plan kBackgroundPlan =
    zstrip::plan(zstrip::count(kBackground), kView, kEffects,
                 {.strip_rows = 16, .layer = zstrip::layer_bytes(kView, kDepthPool, kColourPool)})
        .plan;
constexpr zstrip::SceneCounts kMovingCounts{.instances = 1, .triangles = 6, .vertices = 5, .largest_meshlet = 5};
constexpr zstrip::Plan kMovingPlan = zstrip::plan(kMovingCounts, kView, kEffects, {.strip_rows = 16}).plan;
static_assert(kBackgroundPlan.strips > 0 && kMovingPlan.bytes() <= kBackgroundPlan.bytes());

zstrip::Renderer<kEffects> renderer;
zstrip::StaticLayer layer;
zstrip::Camera camera;
alignas(zstrip::kArenaAlignment) std::byte arena[kBackgroundPlan.bytes()];
std::byte depth_pool[kDepthPool], colour_pool[kColourPool];
std::uint32_t dirty[zstrip::dirty_tile_words(kView.width, kView.height)];
std::uint16_t pixels[16 * kView.width], depth[16 * kView.width];

zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = kDataCommand, .select = kSelect}, kHertz);
zstrip::hal::St7789 panel(bus, waiting);

void stop_on(const zstrip::Status& status) {
  if (status) return;
  Serial.println(zstrip::message(status.error));
  for (;;) delay(1000);
}

void setup() {
  Serial.begin(115200);
  bus.start();
  zstrip::hal::ArduinoPin reset(kReset);
  (void)zstrip::hal::reset_panel(reset, waiting);
  const zstrip::hal::Error error = panel.start();
  if (error != zstrip::hal::Error::none) Serial.println(zstrip::hal::message(error));

  // Both layers use this camera, with one depth range for all frames, so that their depths can be compared.
  camera.fixed_depth_range = true;
  camera.near_plane = 2 << 16;
  camera.far_plane = 9 << 16;
  stop_on(zstrip::orbit(camera, {0, 0, 0}, 5 << 16, 0, 65536 * 3 / 16));

  const std::span<std::byte> strip_pixels = std::as_writable_bytes(std::span(pixels));
  stop_on(layer.reset({depth_pool, colour_pool, dirty}, kView));
  stop_on(renderer.begin_frame(kBackground, camera, kView, kBackgroundPlan, arena));
  for (std::uint16_t strip = 0; strip < kBackgroundPlan.strips; ++strip) {
    stop_on(renderer.draw_strip(strip, strip_pixels));
    stop_on(layer.keep(renderer.frame(), strip, strip_pixels));
  }
}

void loop() {
  // To the right and back, behind two pyramids and in front of the third: depth decides.
  static zstrip::Fixed x = -131072, step = 4096;
  if (x + step > 131072 || x + step < -131072) step = -step;
  x += step;
  moving[0] = at(x, -68000, 20000);

  stop_on(renderer.begin_frame(kMoving, camera, kView, kMovingPlan, arena));
  layer.move_to(renderer.frame().bounds());
  zstrip::Rect area;
  while (layer.next(area, sizeof pixels / sizeof pixels[0])) {
    stop_on(layer.restore(area, pixels, depth));
    stop_on(renderer.draw_over(area, pixels, depth));
    const std::size_t count = static_cast<std::size_t>(area.width() * area.height());
    for (std::size_t i = 0; i < count; ++i) pixels[i] = static_cast<std::uint16_t>(pixels[i] << 8 | pixels[i] >> 8);
    const auto side = [](std::int32_t length) { return static_cast<std::uint16_t>(length); };
    (void)panel.write({side(area.left), side(area.top), side(area.width()), side(area.height())},
                      std::as_bytes(std::span(pixels).first(count)));
    (void)panel.wait();
  }
}
