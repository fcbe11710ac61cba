// Records of depth: hand-made ones of every kind decode to what docs/formats.md says, the encoder chooses the kinds
// that it should, and no bytes whatever make the decoder fail otherwise than by saying so.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "zstrip/store/depth_store.hpp"

namespace {

using namespace zstrip;

using Bytes = std::vector<std::uint8_t>;
constexpr std::uint16_t kUntouched = 0xA55A;

/// 8 x 8 cells and a border that must stay as it is.
struct Decoded {
  bool good = false;
  std::uint32_t width, height;
  std::vector<std::uint16_t> cells;

  Decoded(const Bytes& record, std::uint32_t w, std::uint32_t h) : width(w), height(h), cells(10 * 10, kUntouched) {
    // A heap buffer of exactly the record's size, so that AddressSanitizer sees every byte too many.
    const std::unique_ptr<std::byte[]> exact(new std::byte[record.size()]);
    for (std::size_t i = 0; i < record.size(); ++i) exact[i] = std::byte{record[i]};
    good = decode_depth_tile({exact.get(), record.size()}, {cells.data() + 11, 10, w, h});
    for (std::uint32_t y = 0; y < 10; ++y) {
      for (std::uint32_t x = 0; x < 10; ++x) {
        const bool inside = x >= 1 && x <= w && y >= 1 && y <= h;
        EXPECT_TRUE(inside || cells[y * 10 + x] == kUntouched) << "outside the tile at " << x << ", " << y;
      }
    }
  }
  std::uint16_t at(std::uint32_t x, std::uint32_t y) const { return cells[(y + 1) * 10 + x + 1]; }
};

using Expected = std::function<int(std::uint32_t x, std::uint32_t y)>;

void expect_cells(const Bytes& record, std::uint32_t width, std::uint32_t height, const Expected& expected) {
  const Decoded decoded(record, width, height);
  ASSERT_TRUE(decoded.good);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      ASSERT_EQ(decoded.at(x, y), static_cast<std::uint16_t>(expected(x, y))) << "cell " << x << ", " << y;
    }
  }
}

/// The fields of a plane, lowest bits first.
Bytes plane_fields(std::initializer_list<std::pair<std::int64_t, int>> fields) {
  std::uint64_t bits = 0;
  int used = 0;
  for (const auto& [value, width] : fields) {
    bits |= (static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << width) - 1)) << used;
    used += width;
  }
  Bytes bytes;
  for (int i = 0; i < used; i += 8) bytes.push_back(static_cast<std::uint8_t>(bits >> i));
  return bytes;
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::uint8_t head(int opcode, int cover) { return static_cast<std::uint8_t>(opcode * 4 + cover); }

int whole(double value) { return static_cast<int>(std::floor(value)); }

TEST(DepthRecord, EmptyIsCleared) {
  expect_cells({}, 8, 8, [](auto, auto) { return 0; });
  expect_cells({}, 3, 1, [](auto, auto) { return 0; });
}

TEST(DepthRecord, RawIsLittleEndianRowByRow) {
  expect_cells({1, 0, 2, 0, 3, 1, 4, 2, 5, 0, 0, 255}, 3, 2, [](auto x, auto y) {
    constexpr int kCells[] = {1, 2, 259, 516, 5, 65280};
    return kCells[y * 3 + x];
  });
}

TEST(DepthRecord, PlaneOf5Bytes) {
  // Start 1000.25 in 16.2; slopes with 2 + 3 fraction bits.
  expect_cells(Bytes{head(3, 0)} + plane_fields({{4001, 18}, {49, 11}, {-9, 11}}), 8, 8,
               [](auto x, auto y) { return whole(1000.25 + x * 49 / 32.0 - y * 9 / 32.0); });
}

TEST(DepthRecord, PlaneOf6Bytes) {
  // 16.4; 4 + 7 fraction bits.
  expect_cells(Bytes{head(7, 0)} + plane_fields({{777 * 16 + 5, 20}, {-8191, 14}, {8191, 14}}), 8, 8,
               [](auto x, auto y) { return whole(777 + 5 / 16.0 - x * 8191 / 2048.0 + y * 8191 / 2048.0); });
}

TEST(DepthRecord, PlaneOf8Bytes) {
  // 16.8; 8 + 0 fraction bits; a partial tile.
  expect_cells(Bytes{head(0, 0)} + plane_fields({{40000 * 256 + 255, 24}, {-300001, 20}, {500000, 20}}), 7, 5,
               [](auto x, auto y) { return whole(40000 + 255 / 256.0 - x * 300001 / 256.0 + y * 500000 / 256.0); });
}

TEST(DepthRecord, PlaneInGoldenBytes) {
  // 0x0400 = 4 << 8: start 16.2 of 256, no slopes but 1 a row (16 with 4 fraction bits, at bits 29 to 39).
  expect_cells({2 << 2, 0x00, 0x04, 0x00, 0x00, 0x02}, 8, 8, [](auto, auto y) { return 256 + static_cast<int>(y); });
}

TEST(DepthRecord, Covers) {
  const Bytes flat = plane_fields({{100 * 4, 18}, {0, 11}, {0, 11}});
  const auto where = [](bool covered) { return covered ? 100 : 0; };
  expect_cells(Bytes{head(0, 1), 0x10, 0x32, 0x54, 0x86} + flat, 8, 8, [&](auto x, auto y) {
    constexpr std::uint32_t kLeading[] = {0, 1, 2, 3, 4, 5, 6, 8};
    return where(x < kLeading[y]);
  });
  expect_cells(Bytes{head(0, 2), 0x10, 0x32, 0x54, 0x86} + flat, 8, 8, [&](auto x, auto y) {
    constexpr std::uint32_t kFirst[] = {0, 1, 2, 3, 4, 5, 6, 8};
    return where(x >= kFirst[y]);
  });
  expect_cells(Bytes{head(0, 3), 0x01, 0x80, 0x55, 0xFF, 0, 0, 0, 0xAA} + flat, 8, 8, [&](auto x, auto y) {
    constexpr std::uint32_t kBits[] = {0x01, 0x80, 0x55, 0xFF, 0, 0, 0, 0xAA};
    return where((kBits[y] >> x & 1) != 0);
  });
  // A narrow tile: splits beyond its width are its width; three rows take two bytes.
  expect_cells(Bytes{head(0, 1), 0xF2, 0x0F} + flat, 5, 3, [&](auto x, auto y) { return where(y > 0 || x < 2); });
}

TEST(DepthRecord, Offsets) {
  // 1 + 3 bits a cell from the top of each byte on: 0 1 2 3 4 5 6 7 ...; 8 cells a row are 3 bytes.
  Bytes record{head(16 + 3, 0), 0x34, 0x12};
  for (int row = 0; row < 8; ++row) record = record + Bytes{0x05, 0x39, 0x77};
  expect_cells(record, 8, 8, [](auto x, auto) { return 0x1234 + static_cast<int>(x); });
  // No bits: all cells are alike. Only covered ones count.
  expect_cells({head(16, 3), 0x80, 0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x07, 0x00}, 8, 8, [](auto x, auto y) {
    constexpr std::uint32_t kColumn[] = {7, 0, 1, 2, 3, 4, 5, 6};
    return x == kColumn[y] ? 7 : 0;
  });
}

/// Rows with residual 1 in column 1 only: 2 bits a code (00 01 00 00 ...).
Bytes slope_of_one(int opcode, std::uint32_t rows_with_codes) {
  Bytes record{head(opcode, 0), 0xE8, 0x03, 0, 0, 0, 0};
  for (std::uint32_t y = 0; y < rows_with_codes; ++y) {
    record[3 + y / 2] = static_cast<std::uint8_t>(record[3 + y / 2] | 2 << (y % 2 * 4));
    record = record + Bytes{0x10, 0x00};
  }
  return record;
}

TEST(DepthRecord, FirstRowContinuesItselfForAllPredictors) {
  // One code: the first row is 1000, 1001, 1002 ...; the rows below follow it.
  for (const int opcode : {8, 9, 10}) {
    expect_cells(slope_of_one(opcode, 1), 8, 8, [](auto x, auto) { return 1000 + static_cast<int>(x); });
  }
}

TEST(DepthRecord, SecondRowTellsThePredictorsApart) {
  // Row 1 gets a residual of 1 in column 1, on top of the slope of row 0. Predicted from
  // its own row: the slope is 2 from there on, in all rows below too;
  expect_cells(slope_of_one(8, 2), 8, 8, [](auto x, auto y) { return 1000 + static_cast<int>(y == 0 ? x : 2 * x); });
  // left + up - upleft: 1 more than the row above, in the rows below the same;
  expect_cells(slope_of_one(9, 2), 8, 8,
               [](auto x, auto y) { return 1000 + static_cast<int>(x) + (y > 0 && x > 0 ? 1 : 0); });
  // its column: each row 1 more than the one above.
  expect_cells(slope_of_one(10, 2), 8, 8, [](auto x, auto y) { return 1000 + static_cast<int>(x + (x > 0 ? y : 0)); });
}

TEST(DepthRecord, FirstColumnContinuesItself) {
  // 8 rows of one cell: start 500, then 503, 506 ...: row 1 has a code of 3 bits (011), all else is predicted.
  expect_cells({head(9, 0), 0xF4, 0x01, 0x30, 0, 0, 0, 0x60}, 1, 8,
               [](auto, auto y) { return 500 + 3 * static_cast<int>(y); });
}

TEST(DepthRecord, EscapesAndWholeWords) {
  // Row 0: width 3, cell 3 escapes (100) to +1000; row 1: width 15, 16 bits each: minus 1000 from cell 3 on.
  Bytes record{head(9, 0), 0x64, 0x00, 0xF3, 0, 0, 0};
  record = record + Bytes{0b00000000, 0b01000000, 0b00000000};
  for (int x = 0; x < 8; ++x) {
    const int residual = x == 3 ? -1000 : 0;
    record =
        record + Bytes{static_cast<std::uint8_t>((residual >> 8) & 255), static_cast<std::uint8_t>(residual & 255)};
  }
  record = record + Bytes{0xE8, 0x03};  // the literal, little endian, at the end
  // Row 0 continues linearly behind the jump: 100 100 100 1100 2100 ...
  const auto row_0 = [](std::uint32_t x) { return x < 3 ? 100 : 100 + 1000 * static_cast<int>(x - 2); };
  expect_cells(record, 8, 8, [&](auto x, auto y) { return row_0(x) - (y > 0 && x >= 3 ? 1000 : 0); });
}

TEST(DepthRecord, LiteralsStandBackwards) {
  // Width 1: 0 or escape. Cells 2 and 5 escape: the first literal is the last of the record.
  expect_cells({head(8, 0), 0x0A, 0x00, 0x01, 0b00100100, 0xFB, 0xFF, 0x05, 0x00}, 8, 1, [](auto x, auto) {
    constexpr int kCells[] = {10, 10, 15, 20, 25, 25, 25, 25};  // + 5 a cell, then - 5
    return kCells[x];
  });
}

TEST(DepthRecord, ResidualsOfCoveredCellsOnly) {
  // Trailing cells; uncovered ones are predicted on, and then cleared. Row 0: cells 4..7 = 1000 (codes 0),
  // row 1: cells 6 and 7, + 1 (01 00).
  Bytes record{head(9, 2), 0x64, 0x88, 0x88, 0x88, 0xE8, 0x03, 0x22, 0, 0, 0, 0x00, 0x40};
  expect_cells(record, 8, 8, [](auto x, auto y) { return y == 0 && x >= 4 ? 1000 : y == 1 && x >= 6 ? 1001 : 0; });
}

TEST(DepthRecord, WrongSizesAndOpcodesAreRefused) {
  const auto refused = [](const Bytes& record, std::uint32_t width = 8, std::uint32_t height = 8) {
    return !Decoded(record, width, height).good;
  };
  for (const unsigned bytes : {0U, 1U, 2U, 3U, 4U, 7U, 9U, 20U})
    EXPECT_TRUE(refused(Bytes{head(0, 0)} + Bytes(bytes, 0))) << bytes;
  EXPECT_TRUE(refused(Bytes(129, 0)));
  EXPECT_TRUE(refused(Bytes(13, 0), 3, 2));
  for (const int opcode : {11, 12, 15, 32, 63}) EXPECT_TRUE(refused(Bytes{head(opcode, 0), 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(refused({head(0, 3), 1, 2}));
  EXPECT_TRUE(refused({head(8, 0), 0, 0, 0, 0, 0}));
  EXPECT_TRUE(refused(slope_of_one(8, 2) + Bytes{0}));  // a byte too many
  Bytes short_by_one = slope_of_one(8, 2);
  short_by_one.pop_back();
  EXPECT_TRUE(refused(short_by_one));
  EXPECT_TRUE(refused({head(8, 0), 0, 0, 1, 0, 0, 0, 0x80}));  // an escape without its literal
  EXPECT_TRUE(refused({head(17, 0), 0, 0, 1, 2, 3}));
}

std::vector<std::byte> encoded(const std::vector<std::uint16_t>& cells, std::uint32_t width, std::uint32_t height) {
  std::array<std::byte, kLargestTileRecord> record;
  const std::uint32_t size = encode_depth_tile({cells.data(), width, width, height}, record);
  return {record.begin(), record.begin() + size};
}

int opcode_of(const std::vector<std::byte>& record) { return std::to_integer<int>(record.at(0)) >> 2; }

TEST(DepthEncoder, ChoosesTheKind) {
  std::vector<std::uint16_t> cells(64);
  const auto fill = [&cells](const Expected& value) {
    for (std::uint32_t i = 0; i < 64; ++i) cells[i] = static_cast<std::uint16_t>(value(i % 8, i / 8));
    return encoded(cells, 8, 8);
  };
  EXPECT_TRUE(fill([](auto, auto) { return 0; }).empty());
  const auto plane = fill([](auto x, auto y) { return whole(5000.3 + x * 3.7 - y * 0.11); });
  EXPECT_LT(opcode_of(plane), 8);
  EXPECT_LE(plane.size(), 9U);
  const auto edge = fill([](auto x, auto y) { return x > y ? 0 : whole(5000.3 + x * 3.7 - y * 0.11); });
  EXPECT_LT(opcode_of(edge), 8);
  EXPECT_EQ(std::to_integer<int>(edge[0]) & 3, 1);  // leading cells
  EXPECT_LE(edge.size(), 13U);
  const auto curved = fill([](auto x, auto y) { return 5000 + static_cast<int>(x * x * 3 + y * y * 5); });
  EXPECT_TRUE(opcode_of(curved) >= 8 && opcode_of(curved) <= 10);
  std::minstd_rand random(5);
  const auto hundreds = fill([&](auto, auto) { return 5000 + static_cast<int>(random() / 64 % 128); });
  EXPECT_EQ(opcode_of(hundreds), 16 + 7);
  EXPECT_EQ(hundreds.size(), 3U + 56U);
  EXPECT_EQ(fill([&](auto, auto) { return 1 + static_cast<int>(random() / 64 % 65535); }).size(), 128U);
}

TEST(DepthEncoder, ConstantTilesOfAllValuesAreShort) {
  for (int value = 1; value < 65536; value += 13) {
    const std::vector<std::uint16_t> cells(64, static_cast<std::uint16_t>(value));
    EXPECT_LE(encoded(cells, 8, 8).size(), 6U);
  }
}

/// A store of several kinds of tiles, 20 x 19 cells.
std::vector<std::byte> mixed_blob(std::vector<std::uint16_t>& cells) {
  std::minstd_rand random(7);
  cells.resize(20 * 19);
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t x = i % 20, y = i / 20;
    const int plane = whole(3000.5 + x * 5.25 + y * 0.7);
    const int noise = static_cast<int>(random() / 64 % (x < 8 ? 60000 : 6));
    cells[i] = static_cast<std::uint16_t>(y < 8 ? (x < 8 ? plane : x + y < 20 ? plane : 0) : plane / 2 + noise);
  }
  std::vector<std::byte> pool(store_bytes_worst(20, 19));
  DepthStore store;
  EXPECT_TRUE(store.reset(pool, 20, 19));
  EXPECT_TRUE(store.write_rows({cells.data(), 20, 0, 19}));
  const auto blob = store.blob();
  return {blob.begin(), blob.end()};
}

TEST(DepthBlob, TruncatedAtEveryLengthIsRefused) {
  std::vector<std::uint16_t> cells;
  const std::vector<std::byte> blob = mixed_blob(cells);
  for (std::size_t length = 0; length <= blob.size(); ++length) {
    const std::unique_ptr<std::byte[]> exact(new std::byte[length]);
    std::copy_n(blob.begin(), length, exact.get());
    DepthReader reader;
    Status status = reader.open({exact.get(), length});
    std::vector<std::uint16_t> read(20 * 19);
    if (status) status = reader.read_rows({read.data(), 20, 0, 19});
    EXPECT_EQ(static_cast<bool>(status), length == blob.size()) << length;
    if (status) {
      EXPECT_EQ(read, cells);
      EXPECT_TRUE(reader.validate());
    } else {
      EXPECT_EQ(status.error, Error::store_damaged);
    }
  }
}

TEST(DepthBlob, EveryDamagedBitIsHarmless) {
  std::vector<std::uint16_t> cells;
  const std::vector<std::byte> blob = mixed_blob(cells);
  for (std::size_t bit = 0; bit < 8 * blob.size(); ++bit) {
    const std::unique_ptr<std::byte[]> damaged(new std::byte[blob.size()]);
    std::copy(blob.begin(), blob.end(), damaged.get());
    damaged[bit / 8] ^= std::byte{1} << bit % 8;
    DepthReader reader;
    const Status opened = reader.open({damaged.get(), blob.size()});
    if (!opened) {
      EXPECT_EQ(opened.error, Error::store_damaged);
      continue;
    }
    const TileGrid grid = reader.grid();
    std::vector<std::uint16_t> read(std::size_t{grid.width} * grid.height);
    const Status status = reader.read_rows({read.data(), grid.width, 0, grid.height});
    EXPECT_TRUE(status || status.error == Error::store_damaged);
    EXPECT_TRUE(status || !reader.validate());
  }
}

TEST(DepthBlob, OtherKindsAndVersionsAreRefused) {
  std::vector<std::uint16_t> cells;
  for (std::size_t at = 0; at < 4; ++at) {
    std::vector<std::byte> blob = mixed_blob(cells);
    blob[at] ^= std::byte{1};
    DepthReader reader;
    EXPECT_EQ(reader.open(blob).error, Error::store_damaged);
    EXPECT_EQ(reader.read_rows({cells.data(), 20, 0, 19}).error, Error::store_range);
  }
}

TEST(DepthStore, RefusesWhatItDoesNotHave) {
  std::vector<std::byte> pool(store_bytes_worst(20, 19));
  std::vector<std::uint16_t> cells(64);
  DepthStore store;
  EXPECT_EQ(store.write_tile(0, 0, cells.data(), 8).error, Error::store_range);  // before a reset
  EXPECT_EQ(store.read_tile(0, 0, cells.data(), 8).error, Error::store_range);
  EXPECT_TRUE(store.blob().empty());
  for (const auto& [width, height] : {std::pair{0U, 5U}, {5U, 0U}, {4097U, 5U}, {5U, 4097U}}) {
    EXPECT_EQ(store.reset(pool, width, height).error, Error::view_size);
  }
  const Status small = store.reset(std::span(pool).first(20), 20, 19);
  EXPECT_EQ(small.error, Error::store_full);
  EXPECT_EQ(small.needed, 8U + 4 + 9);
  EXPECT_EQ(small.available, 20U);
  ASSERT_TRUE(store.reset(pool, 20, 19));
  EXPECT_EQ(store.bytes_used(), 21U);
  EXPECT_EQ(store.write_tile(3, 0, cells.data(), 8).error, Error::store_range);
  EXPECT_EQ(store.write_tile(0, 3, cells.data(), 8).error, Error::store_range);
  EXPECT_EQ(store.read_rows({cells.data(), 20, 18, 2}).error, Error::store_range);
  EXPECT_EQ(store.write_rows({cells.data(), 20, 0xFFFFFFFF, 2}).error, Error::store_range);
}

// A pool that somebody wrote over: writing may refuse, but stays inside.
TEST(DepthStore, DamagedPoolsAreNotWrittenBeyond) {
  std::minstd_rand engine(11);
  const auto random = [&engine] { return static_cast<std::uint32_t>(engine() >> 8); };
  for (int round = 0; round < 3000; ++round) {
    const std::uint32_t width = 1 + random() % 70, height = 1 + random() % 40;
    std::vector<std::byte> guarded(store_bytes_worst(width, height) + 512, std::byte{0xA5});
    const auto pool = std::span(guarded).subspan(256, guarded.size() - 512);
    DepthStore store;
    ASSERT_TRUE(store.reset(pool, width, height));
    std::vector<std::uint16_t> cells(std::size_t{width} * height);
    for (auto& cell : cells) cell = static_cast<std::uint16_t>(random() % (1U << random() % 17));
    ASSERT_TRUE(store.write_rows({cells.data(), width, 0, height}));
    for (std::uint32_t i = 1 + random() % 9; i > 0; --i)
      pool[random() % pool.size()] = static_cast<std::byte>(random());
    for (int i = 0; i < 12; ++i) {
      const std::uint32_t tx = random() % store.grid().columns(), ty = random() % store.grid().rows();
      const Status status = store.write_tile(tx, ty, cells.data() + (ty * width + tx) * 8, width);
      EXPECT_TRUE(status || status.error == Error::store_damaged || status.error == Error::store_full);
      (void)store.read_rows({cells.data(), width, 0, height}).error;
    }
    (void)store.validate().error;
    (void)store.blob();
    for (std::size_t i = 0; i < 256; ++i) {
      ASSERT_EQ(guarded[i], std::byte{0xA5});
      ASSERT_EQ(guarded[guarded.size() - 1 - i], std::byte{0xA5});
    }
  }
}

}  // namespace
