// Two buffers and DMA: while one strip is being sent to the panel, the next one is drawn. 40 KB of RAM. For boards
// with SPI.transferAsync(), as Raspberry Pi Pico with the core of Earle Philhower; for other boards replace the three
// calls that end in Async by those of the board's SDK.
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

// A bus as zstrip_hal/bus.hpp describes it. Commands are short and are sent without DMA.
class DmaBus {
 public:
  using Error = zstrip::hal::Error;
  void start() { commands_.start(); }
  Error write_command(std::span<const std::byte> bytes) { return commands_.write_command(bytes); }
  Error write_data(std::span<const std::byte> bytes) {
    SPI.beginTransaction(SPISettings(kHertz, MSBFIRST, SPI_MODE0));
    digitalWrite(kDataCommand, HIGH);
    digitalWrite(kSelect, LOW);
    sending_ = true;
    return SPI.transferAsync(bytes.data(), nullptr, bytes.size()) ? Error::none : ended(Error::bus);
  }
  Error wait() {
    if (!sending_) return Error::none;
    const unsigned long start = millis();
    while (!SPI.finishedAsync()) {
      if (millis() - start <= 100) continue;
      SPI.abortAsync();
      return ended(Error::timeout);
    }
    return ended(Error::none);
  }

 private:
  Error ended(Error error) {
    sending_ = false;
    digitalWrite(kSelect, HIGH);
    SPI.endTransaction();
    return error;
  }
  zstrip::hal::ArduinoSpi<decltype(SPI)> commands_{SPI, {.data_command = kDataCommand, .select = kSelect}, kHertz};
  bool sending_ = false;
};

constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
constexpr zstrip::Budget kBudget{.bytes = 40 * 1024, .strip_buffers = 2};
zstrip::FixedRenderer<kScene, kView, kBudget, zstrip::effect::unclipped> renderer;
alignas(4) std::byte first_pixels[renderer.kStripBytes];
alignas(4) std::byte second_pixels[renderer.kStripBytes];

zstrip::hal::ArduinoClock waiting;
DmaBus bus;
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
  const zstrip::Status begun = renderer.begin_frame(camera);
  if (!begun) {
    Serial.println(zstrip::message(begun.error));
    return;
  }
  const auto shown = zstrip::hal::present(renderer, panel, {renderer.kPlan.strips, renderer.kPlan.strip_rows},
                                          {first_pixels, second_pixels});
  if (!shown) Serial.println(shown.draw ? zstrip::hal::message(shown.display) : zstrip::message(shown.draw.error));
}
