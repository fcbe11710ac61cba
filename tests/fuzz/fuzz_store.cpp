// The stores of depth and colour: any bytes as a record, a blob or a damaged pool are refused or read, and never make
// it touch memory elsewhere; any cells come back as they were, in no more bytes than promised.
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "input.hpp"
#include "require.hpp"
#include "zstrip/store/colour_store.hpp"
#include "zstrip/store/depth_store.hpp"

namespace {

using namespace zstrip;

/// On the heap and of exactly this size: AddressSanitizer guards both ends.
struct Exact {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t size;

  explicit Exact(std::size_t s) : bytes(new std::byte[s]()), size(s) {}
  std::span<std::byte> span() { return {bytes.get(), size}; }
};

void judge_record(fuzz::Input& input, const detail::TileCodec& codec) {
  const std::uint32_t width = 1 + input.below(8), height = 1 + input.below(8);
  Exact record(input.below(140));
  for (std::byte& byte : record.span()) byte = static_cast<std::byte>(input.any<std::uint8_t>());
  std::vector<std::uint16_t> cells(std::size_t{width} * height);
  if (!codec.decode(record.span(), {cells.data(), width, width, height})) return;
  std::array<std::byte, kMaxTileRecord> again;
  const std::uint32_t size = codec.encode({cells.data(), width, width, height}, again);
  fuzz::require(size <= 2 * width * height, "a record is no longer than its cells: %u", size);
  std::vector<std::uint16_t> decoded(cells.size());
  fuzz::require(codec.decode(std::span(again).first(size), {decoded.data(), width, width, height}),
                "what was encoded can be decoded");
  fuzz::require(decoded == cells, "and is the same");
}

void judge_blob(fuzz::Input& input) {
  Exact blob(8 + input.below(600));
  const std::array<std::uint8_t, 8> header{'z',
                                           's',
                                           1,
                                           'd',
                                           static_cast<std::uint8_t>(1 + input.below(60)),
                                           0,
                                           static_cast<std::uint8_t>(1 + input.below(60)),
                                           0};
  const bool any_header = input.below(8) == 0;
  for (std::size_t i = 0; i < blob.size; ++i) {
    const auto byte = input.any<std::uint8_t>();
    blob.span()[i] = static_cast<std::byte>(i < header.size() && !any_header ? header[i] : byte);
  }
  DepthReader reader;
  if (!reader.open(blob.span())) return;
  const TileGrid grid = reader.grid();
  if (std::size_t{grid.width} * grid.height > 100'000) return;
  std::vector<std::uint16_t> cells(std::size_t{grid.width} * grid.height);
  const bool readable = static_cast<bool>(reader.read_rows({cells.data(), grid.width, 0, grid.height}));
  const bool valid = static_cast<bool>(reader.validate());
  fuzz::require(readable || !valid, "a valid blob can be read");
  std::vector<std::uint16_t> tile(kTileCells);
  for (std::uint32_t i = 0; i < grid.tiles() && i < 100; ++i) {
    (void)reader.read_tile(i % grid.columns(), i / grid.columns(), tile.data(), kTileSide).error;
  }
}

/// Writes tiles at random into a pool of any size; with `damage` somebody else writes into it, too.
void judge_writing(fuzz::Input& input, bool damage) {
  const std::uint32_t width = 1 + input.below(40), height = 1 + input.below(40);
  Exact pool(input.flag() ? store_bytes_worst(width, height) : input.below(store_bytes_worst(width, height)));
  DepthStore store;
  if (!store.reset(pool.span(), width, height)) return;
  std::vector<std::uint16_t> plain(std::size_t{width} * height);
  for (std::uint32_t step = input.below(24); step > 0; --step) {
    std::vector<std::uint16_t> changed = plain;
    const std::uint32_t tx = input.below(store.grid().columns()), ty = input.below(store.grid().rows());
    const std::uint16_t base = input.any<std::uint16_t>();
    const std::uint32_t slope = input.below(9), range = input.below(65536) + 1;
    for (std::uint32_t y = 0; y < store.grid().tile_height(ty); ++y) {
      for (std::uint32_t x = 0; x < store.grid().tile_width(tx); ++x) {
        changed[(ty * 8 + y) * width + tx * 8 + x] =
            static_cast<std::uint16_t>(base + slope * x + (input.flag() ? input.any<std::uint16_t>() % range : 0));
      }
    }
    if (damage) pool.bytes[input.below(static_cast<std::uint32_t>(pool.size))] = std::byte{input.any<std::uint8_t>()};
    const Status status = store.write_tile(tx, ty, changed.data() + (ty * width + tx) * 8, width);
    if (status) plain = changed;
    fuzz::require(status || status.error == Error::store_full || damage, "only room can lack");
    fuzz::require(store.bytes_used() <= pool.size, "the pool is kept");
  }
  std::vector<std::uint16_t> read(plain.size());
  const Status status = store.read_rows({read.data(), width, 0, height});
  fuzz::require(damage || (status && read == plain), "the store holds what an array would");
  fuzz::require(damage || store.validate(), "and is valid");
  (void)store.blob();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  switch (input.below(5)) {
    case 0: judge_record(input, detail::kDepthCodec); break;
    case 4: judge_record(input, detail::kColourCodec); break;
    case 1: judge_blob(input); break;
    case 2: judge_writing(input, false); break;
    default: judge_writing(input, true); break;
  }
  return 0;
}
