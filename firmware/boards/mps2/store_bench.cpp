// Measures the stores on z-buffers and pictures of built-in scenes, and on noise. Prints one line of JSON for each
// scene and kind of record: the number of its tiles and cells, and the instructions for encoding and decoding 100
// cells. Exit status: 0 done, 1 any error.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "mps2/instruction_counter.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/store/colour_store.hpp"
#include "zstrip/store/depth_record.hpp"
#include "zstrip/store/depth_store.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using zstrip::board::InstructionCounter;
using zstrip::board::print;
using zstrip::board::print_decimal;

constexpr zstrip::View kView{320, 240};
constexpr std::uint32_t kFrames = 6;
constexpr std::uint32_t kRepeats = 8;  // repeats of one tile in a region, because the counter's ticks are coarse

/// Holds the arena, followed by the pixels.
alignas(zstrip::kArenaAlignment) std::byte memory[4'000'000 - 65536];

enum Kind : std::uint8_t {
  kCleared,
  kRaw,
  kPlaneKind,
  kTwoPlanesKind,
  kResiduals,
  kOffsets,
  kOneColour,
  kRawColour,
  kPalette,
  kDifferences,
  kKinds
};
constexpr const char* kNames[kKinds] = {"cleared", "raw",        "plane",      "two planes", "residuals",
                                        "offsets", "one colour", "raw colour", "palette",    "differences"};

Kind kind_of_depth(std::span<const std::byte> record, std::uint32_t area) {
  using namespace zstrip::detail;
  if (record.empty()) return kCleared;
  if (record.size() == 2 * area) return kRaw;
  const unsigned opcode = std::to_integer<unsigned>(record[0]) >> 2;
  if (opcode >= kOffset) return kOffsets;
  if (opcode == kTwoPlanes) return kTwoPlanesKind;
  return opcode >= kAlong ? kResiduals : kPlaneKind;
}

Kind kind_of_colour(std::span<const std::byte> record, std::uint32_t area) {
  if (record.size() <= 2) return kOneColour;
  if (record.size() == 2 * area) return kRawColour;
  return std::to_integer<unsigned>(record[0]) >= 0x80 ? kDifferences : kPalette;
}

struct Measured {
  std::uint32_t tiles = 0, cells = 0, bytes = 0;
  std::uint64_t encoding = 0, decoding = 0;  ///< instructions of kRepeats repeats
};
/// Results of each kind: for records that describe all cells, and for records with a cover.
using Results = std::array<std::array<Measured, 2>, kKinds>;

void measure_tile(const zstrip::detail::TileCodec& codec, const zstrip::TileView<const std::uint16_t>& tile,
                  InstructionCounter& counter, Results& results) {
  static std::array<std::byte, zstrip::kMaxTileRecord> record;
  static std::array<std::uint16_t, zstrip::kTileCells> cells;
  std::uint32_t size = 0;
  counter.reset();
  counter.resume();
  for (std::uint32_t i = 0; i < kRepeats; ++i) size = codec.encode(tile, record);
  counter.pause();
  const std::uint64_t encoding = counter.instructions();
  const auto bytes = std::span<const std::byte>(record).first(size);
  const zstrip::TileView<std::uint16_t> decoded{cells.data(), zstrip::kTileSide, tile.width, tile.height};
  bool good = true;
  counter.reset();
  counter.resume();
  for (std::uint32_t i = 0; i < kRepeats; ++i) good = codec.decode(bytes, decoded) && good;
  counter.pause();
  if (!good) print("a record cannot be decoded\n");

  const bool depth = &codec == &zstrip::detail::kDepthCodec;
  const Kind kind = depth ? kind_of_depth(bytes, tile.area()) : kind_of_colour(bytes, tile.area());
  const bool covered =
      depth && kind >= kPlaneKind && kind != kTwoPlanesKind && (std::to_integer<unsigned>(record[0]) & 3U) != 0;
  Measured& measured = results[kind][covered ? 1 : 0];
  ++measured.tiles;
  measured.cells += tile.area();
  measured.bytes += size;
  measured.encoding += encoding;
  measured.decoding += counter.instructions();
}

void print_member(const char* name, std::uint64_t value) {
  print(", \"");
  print(name);
  print("\": ");
  print_decimal(value);
}

void print_results(const char* name, const Results& results) {
  for (std::uint32_t kind = 0; kind < kKinds; ++kind) {
    for (std::uint32_t covered = 0; covered < 2; ++covered) {
      const Measured& measured = results[kind][covered];
      if (measured.tiles == 0) continue;
      print("{\"target\": \"" ZSTRIP_TARGET "\", \"scene\": \"");
      print(name);
      print("\", \"kind\": \"");
      print(kNames[kind]);
      print(covered != 0 ? " with a cover\"" : "\"");
      print_member("tiles", measured.tiles);
      print_member("cells", measured.cells);
      print_member("bytes", measured.bytes);
      print_member("encode_per_100_cells", measured.encoding * 100 / kRepeats / measured.cells);
      print_member("decode_per_100_cells", measured.decoding * 100 / kRepeats / measured.cells);
      print("}\n");
    }
  }
}

/// Measures each tile of a picture, whose rows are `stride` apart.
void measure_tiles(const zstrip::detail::TileCodec& codec, const std::uint16_t* cells, std::uint32_t stride,
                   const zstrip::TileGrid& grid, InstructionCounter& counter, Results& results) {
  for (std::uint32_t tile = 0; tile < grid.tiles(); ++tile) {
    const std::uint32_t tx = tile % grid.columns(), ty = tile / grid.columns();
    measure_tile(codec,
                 {cells + (ty * stride + tx) * zstrip::kTileSide, stride, grid.tile_width(tx), grid.tile_height(ty)},
                 counter, results);
  }
}

/// Measures noise, which only raw records can hold.
void run_noise() {
  static std::array<std::uint16_t, 64 * zstrip::kTileCells> cells;
  std::uint32_t random = 1;
  for (std::uint16_t& cell : cells) {
    random = random * 1664525 + 1013904223;
    cell = static_cast<std::uint16_t>(random >> 16 | 1);
  }
  InstructionCounter counter;
  Results results{};
  for (const auto* codec : {&zstrip::detail::kDepthCodec, &zstrip::detail::kColourCodec}) {
    measure_tiles(*codec, cells.data(), 64, {64, 64}, counter, results);
  }
  print_results("noise", results);
}

template <const zstrip::scenes::BuiltIn& built_in>
bool run() {
  constexpr zstrip::Effects kEffects = effects_of(built_in.scene, built_in.camera);
  static zstrip::Renderer<kEffects> renderer;
  static zstrip::scenes::Staged staged;
  const auto [status, plan] = zstrip::plan(built_in.counts, kView, kEffects, {.strip_rows = kView.height});
  if (!status || plan.bytes() + plan.strip_pixel_bytes(kView) > sizeof memory) return false;

  InstructionCounter counter;
  Results results{};
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    if constexpr (built_in.turns == zstrip::scenes::Turns::camera) {
      stage(built_in, staged, frame, kFrames, kView);
    } else {
      stage_workload(built_in, staged, 10 * frame);
    }
    if (!renderer.begin_frame(staged.scene, staged.camera, kView, plan, std::span(memory, plan.bytes()))) return false;
    if (!renderer.draw_strip(0, std::span(memory + plan.bytes(), plan.strip_pixel_bytes(kView)))) return false;
    const zstrip::Rect area = renderer.frame().depth_area();
    const zstrip::TileGrid grid{static_cast<std::uint32_t>(area.width()), static_cast<std::uint32_t>(area.height())};
    measure_tiles(zstrip::detail::kDepthCodec, renderer.frame().depth(), grid.width, grid, counter, results);
    const auto* const pixels = reinterpret_cast<const std::uint16_t*>(memory + plan.bytes());
    const auto corner = static_cast<std::uint32_t>(area.top) * kView.width + static_cast<std::uint32_t>(area.left);
    measure_tiles(zstrip::detail::kColourCodec, pixels + corner, kView.width, grid, counter, results);
  }
  print_results(built_in.name, results);
  return true;
}

}  // namespace

int main() {
  if (!zstrip::board::start_instruction_counter()) {
    print("store bench: the timer does not count instructions; run QEMU with -icount shift=0\n");
    return 1;
  }
  run_noise();
  return run<zstrip::scenes::room>() && run<zstrip::scenes::knot>() && run<zstrip::scenes::random10k>() ? 0 : 1;
}
