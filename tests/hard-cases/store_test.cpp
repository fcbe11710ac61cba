// Hard cases E: the compressed depth store. What is read is what was written, whatever was written, in whatever order
// and however little room there is.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <vector>

#include "generators.hpp"
#include "zstrip/store/depth_store.hpp"

namespace hard_cases {
namespace {

struct Cells {
  std::uint32_t width, height;
  std::vector<std::uint16_t> cells;

  Cells(std::uint32_t w, std::uint32_t h) : width(w), height(h), cells(std::size_t{w} * h) {}
  std::uint16_t& at(std::uint32_t x, std::uint32_t y) { return cells[std::size_t{y} * width + x]; }
  RowsView<const std::uint16_t> rows() const { return {cells.data(), width, 0, height}; }
  friend bool operator==(const Cells&, const Cells&) = default;
};

Cells random_size(int largest = 40) {
  return {static_cast<std::uint32_t>(between(1, largest)), static_cast<std::uint32_t>(between(1, largest))};
}

/// A plane as a rasteriser makes it: 16.16, truncated.
struct ExactPlane {
  std::int64_t start, step_x, step_y;

  static ExactPlane any(int steepest) {
    const auto slope = [steepest] { return std::int64_t{between(-steepest, steepest)} * between(1, 65536) / 16; };
    return {(std::int64_t{between(1, 65535)} << 16) + between(0, 65535), slope(), slope()};
  }
  std::uint16_t at(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::uint16_t>(std::clamp<std::int64_t>((start + step_x * x + step_y * y) >> 16, 1, 65535));
  }
};

/// Any number of planes, each where it is nearest, holes, and noise.
Cells any_cells(int largest = 40) {
  Cells result = random_size(largest);
  const int planes = between(0, 6), noise = between(0, 3) == 0 ? between(1, 65535) : 0;
  for (int i = 0; i < planes; ++i) {
    const ExactPlane plane = ExactPlane::any(between(0, 4) == 0 ? 4000 : 40);
    const int left = between(-8, static_cast<int>(result.width)), top = between(-8, static_cast<int>(result.height));
    const int right = left + between(1, 40), bottom = top + between(1, 40), lean = between(-3, 3);
    for (std::uint32_t y = 0; y < result.height; ++y) {
      for (std::uint32_t x = 0; x < result.width; ++x) {
        const int column = static_cast<int>(x) + lean * static_cast<int>(y), row = static_cast<int>(y);
        if (column < left || column >= right || row < top || row >= bottom) continue;
        result.at(x, y) = std::max(result.at(x, y), plane.at(x, y));
      }
    }
  }
  if (noise > 0) {
    for (std::uint16_t& cell : result.cells) {
      if (between(0, 1) == 0) cell = static_cast<std::uint16_t>(between(0, noise));
    }
  }
  return result;
}

/// A pool with guards on both sides, which must stay as they are.
class Pool {
 public:
  explicit Pool(std::size_t size) : bytes_(size + 2 * kGuard, kFilling) {}
  ~Pool() {
    for (std::size_t i = 0; i < kGuard; ++i) {
      EXPECT_EQ(bytes_[i], kFilling);
      EXPECT_EQ(bytes_[bytes_.size() - 1 - i], kFilling);
    }
  }
  std::span<std::byte> span() { return std::span(bytes_).subspan(kGuard, bytes_.size() - 2 * kGuard); }

 private:
  static constexpr std::size_t kGuard = 160;
  static constexpr std::byte kFilling{0xA5};
  std::vector<std::byte> bytes_;
};

Cells read_back(const detail::TileReader& store) {
  Cells result(store.grid().width, store.grid().height);
  std::fill(result.cells.begin(), result.cells.end(), std::uint16_t{0x5AA5});
  RC_ASSERT(store.read_rows({result.cells.data(), result.width, 0, result.height}));
  return result;
}

void expect_round_trip(const Cells& cells) {
  Pool pool(store_bytes_worst(cells.width, cells.height));
  DepthStore store;
  RC_ASSERT(store.reset(pool.span(), cells.width, cells.height));
  RC_ASSERT(store.write_rows(cells.rows()));
  RC_ASSERT(store.bytes_used() <= store_bytes_worst(cells.width, cells.height));
  RC_ASSERT(store.validate());
  RC_ASSERT(read_back(store) == cells);
  // And as a blob of exactly its size.
  const auto blob = store.blob();
  const std::vector<std::byte> copy(blob.begin(), blob.end());
  DepthReader reader;
  RC_ASSERT(reader.open(copy));
  RC_ASSERT(reader.validate());
  RC_ASSERT(read_back(reader) == cells);
}

RC_GTEST_PROP(HardCases, E55_ReadIsWhatWasWritten, ()) { expect_round_trip(any_cells()); }

RC_GTEST_PROP(HardCases, E55_OnePlaneAtAnySlope, ()) {
  Cells cells = random_size(16);
  const ExactPlane plane = ExactPlane::any(between(0, 3) == 0 ? 65535 : 100);
  for (std::uint32_t y = 0; y < cells.height; ++y) {
    for (std::uint32_t x = 0; x < cells.width; ++x) cells.at(x, y) = plane.at(x, y);
  }
  expect_round_trip(cells);
}

RC_GTEST_PROP(HardCases, E56_NoiseKeepsTheBudget, ()) {
  Cells cells = random_size();
  for (std::uint16_t& cell : cells.cells) cell = static_cast<std::uint16_t>(between(0, 65535));
  expect_round_trip(cells);
}

TEST(HardCases, E56_NoiseOfAllBitsIsRawAndOneByteATile) {
  Cells cells(320, 240);
  std::uint32_t state = 1;
  for (std::uint16_t& cell : cells.cells)
    cell = static_cast<std::uint16_t>((state = state * 1664525 + 1013904223) >> 16);
  Pool pool(store_bytes_worst(320, 240));
  DepthStore store;
  ASSERT_TRUE(store.reset(pool.span(), 320, 240));
  ASSERT_TRUE(store.write_rows(cells.rows()));
  EXPECT_EQ(store.bytes_used(), store_bytes_worst(320, 240));
  EXPECT_LE(store_bytes_worst(320, 240), 320U * 240 * 2 + 1200 + 1200 / 8 + 16);
}

/// What is drawn over a decoded tile or strip.
void draw_over(Cells& cells) {
  const ExactPlane plane = ExactPlane::any(100);
  const auto left = static_cast<std::uint32_t>(between(0, static_cast<int>(cells.width) - 1)),
             top = static_cast<std::uint32_t>(between(0, static_cast<int>(cells.height) - 1));
  const std::uint32_t right = std::min(left + static_cast<std::uint32_t>(between(1, 20)), cells.width),
                      bottom = std::min(top + static_cast<std::uint32_t>(between(1, 20)), cells.height);
  for (std::uint32_t y = top; y < bottom; ++y) {
    for (std::uint32_t x = left; x < right; ++x) cells.at(x, y) = std::max(cells.at(x, y), plane.at(x, y));
  }
}

// Tiles in any order, rows from any row on: the store holds what an array would.
RC_GTEST_PROP(HardCases, E57_ReopenedTilesAreAsIfNeverCompressed, ()) {
  Cells plain = random_size(80);
  Pool pool(store_bytes_worst(plain.width, plain.height));
  DepthStore store;
  RC_ASSERT(store.reset(pool.span(), plain.width, plain.height));
  const TileGrid& grid = store.grid();
  for (int step = between(1, 12); step > 0; --step) {
    Cells drawn = read_back(store);
    RC_ASSERT(drawn == plain);
    draw_over(plain);
    if (between(0, 1) == 0) {
      const auto top = static_cast<std::uint32_t>(between(0, static_cast<int>(plain.height) - 1));
      const auto rows = static_cast<std::uint32_t>(between(1, static_cast<int>(plain.height - top)));
      RC_ASSERT(store.write_rows({plain.cells.data() + std::size_t{top} * plain.width, plain.width, top, rows}));
    }
    // Tiles that differ, or not, from the last one to the first or the other way round.
    const bool backwards = between(0, 1) == 0;
    for (std::uint32_t i = 0; i < grid.tiles(); ++i) {
      const std::uint32_t tile = backwards ? grid.tiles() - 1 - i : i;
      const std::uint32_t tx = tile % grid.columns(), ty = tile / grid.columns();
      RC_ASSERT(store.write_tile(tx, ty, &plain.at(tx * kTileSide, ty * kTileSide), plain.width));
    }
    RC_ASSERT(store.validate());
  }
  RC_ASSERT(read_back(store) == plain);
}

// In single tiles at random places, with a pool of exactly what the worst needs.
RC_GTEST_PROP(HardCases, E57_SizesThatChangeLeaveNoHoles, ()) {
  Cells plain = random_size(80);
  Pool pool(store_bytes_worst(plain.width, plain.height));
  DepthStore store;
  RC_ASSERT(store.reset(pool.span(), plain.width, plain.height));
  for (int step = between(1, 60); step > 0; --step) {
    const auto tx = static_cast<std::uint32_t>(between(0, static_cast<int>(store.grid().columns()) - 1)),
               ty = static_cast<std::uint32_t>(between(0, static_cast<int>(store.grid().rows()) - 1));
    const std::uint32_t width = store.grid().tile_width(tx), height = store.grid().tile_height(ty);
    const int range = between(0, 3) == 0 ? 0 : 1 << between(0, 15);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        plain.at(tx * 8 + x, ty * 8 + y) = static_cast<std::uint16_t>(between(0, range));
      }
    }
    RC_ASSERT(store.write_tile(tx, ty, &plain.at(tx * 8, ty * 8), plain.width));
  }
  RC_ASSERT(store.validate());
  RC_ASSERT(read_back(store) == plain);
}

// Too little room: the write that does not fit is refused with the bytes that it needs, and nothing else changes.
RC_GTEST_PROP(HardCases, E58_ExhaustedPoolRefusesAndKeepsAll, ()) {
  Cells plain = random_size(60);
  const std::uint32_t empty = detail::index_bytes({plain.width, plain.height});
  const auto room = static_cast<std::uint32_t>(between(0, static_cast<int>(2 * plain.cells.size())));
  Pool pool(empty + room);
  DepthStore store;
  RC_ASSERT(store.reset(pool.span(), plain.width, plain.height));
  for (int step = between(1, 60); step > 0; --step) {
    const auto tx = static_cast<std::uint32_t>(between(0, static_cast<int>(store.grid().columns()) - 1)),
               ty = static_cast<std::uint32_t>(between(0, static_cast<int>(store.grid().rows()) - 1));
    Cells changed = plain;
    const int range = 1 << between(0, 16);
    for (std::uint32_t y = 0; y < store.grid().tile_height(ty); ++y) {
      for (std::uint32_t x = 0; x < store.grid().tile_width(tx); ++x) {
        changed.at(tx * 8 + x, ty * 8 + y) = static_cast<std::uint16_t>(between(0, range - 1));
      }
    }
    const std::uint32_t used = store.bytes_used();
    const Status status = store.write_tile(tx, ty, &changed.at(tx * 8, ty * 8), plain.width);
    if (status) {
      plain = changed;
    } else {
      RC_ASSERT(status.error == Error::store_full);
      RC_ASSERT(status.purpose == Purpose::depth);
      RC_ASSERT(status.available == empty + room);
      RC_ASSERT(status.needed > status.available);
      RC_ASSERT(store.bytes_used() == used);
    }
    RC_ASSERT(store.bytes_used() <= empty + room);
  }
  RC_ASSERT(store.validate());
  RC_ASSERT(read_back(store) == plain);
}

// The bytes that an error asks for suffice, and one fewer does not.
RC_GTEST_PROP(HardCases, E58_TheBytesThatAnErrorAsksForSuffice, ()) {
  const Cells cells = any_cells();
  std::vector<std::byte> pool(store_bytes_worst(cells.width, cells.height));
  DepthStore store;
  RC_ASSERT(store.reset(pool, cells.width, cells.height));
  RC_ASSERT(store.write_rows(cells.rows()));
  const std::uint32_t enough = store.bytes_used();
  Pool exact(enough);
  RC_ASSERT(store.reset(exact.span(), cells.width, cells.height));
  RC_ASSERT(store.write_rows(cells.rows()));
  RC_ASSERT(read_back(store) == cells);
  Pool less(enough - 1);
  const Status status = store.reset(less.span(), cells.width, cells.height);
  const Status written = status ? store.write_rows(cells.rows()) : status;
  RC_ASSERT(written.error == Error::store_full);
  RC_ASSERT(written.needed == enough);
}

}  // namespace
}  // namespace hard_cases
