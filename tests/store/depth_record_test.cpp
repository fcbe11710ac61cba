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

TEST(DepthRecord, TwoPlanes) {
  // Cells x < 3 of all rows on a plane of 6 bytes (form 1, 16.4), the others on one of 5 bytes (16.2).
  const Bytes first = plane_fields({{300 * 16, 20}, {-16, 14}, {0, 14}});
  const Bytes others = plane_fields({{100 * 4, 18}, {4 << 3, 11}, {2 << 3, 11}});
  const auto expected = [](std::uint32_t x, std::uint32_t y) {
    return x < 3 ? 300 - static_cast<int>(x) : 100 + static_cast<int>(x) + static_cast<int>(y) / 2;
  };
  expect_cells(Bytes{head(11, 1), 0x33, 0x33, 0x33, 0x33, 0 | 3 << 3 | 1 << 6} + first + others, 8, 8, expected);
  expect_cells(Bytes{head(11, 1), 0x33, 0x03, 0 | 3 << 3 | 1 << 6} + first + others, 5, 3, expected);
  // All cells are the first plane's: the other one is not seen.
  expect_cells(Bytes{head(11, 0), 0 | 3 << 3 | 1 << 6} + first + others, 8, 8,
               [](auto x, auto) { return 300 - static_cast<int>(x); });
}

TEST(DepthRecord, Offsets) {
  // Codes of 3 bits from -4 to 3: 100 101 110 111 000 001 010 011, the last byte first.
  Bytes record{head(16 + 3, 0), 0x34, 0x12};
  for (int row = 0; row < 8; ++row) record = record + Bytes{0x53, 0x70, 0x97};
  expect_cells(record, 8, 8, [](auto x, auto) { return 0x1234 - 4 + static_cast<int>(x); });
  // Only covered cells count. 10 bits: 0x12C, 0x2D4 (-300) and 5: their low bytes, then 01 10 00.
  expect_cells({head(16 + 10, 3), 0x80, 0x01, 0, 0, 0, 0, 0, 0x02, 0xE8, 0x03, 0x2C, 0xD4, 0x05, 0x60}, 8, 8,
               [](auto x, auto y) {
                 return x == 7 && y == 0 ? 1300 : x == 0 && y == 1 ? 700 : x == 1 && y == 7 ? 1005 : 0;
               });
}

/// The codes of a record as docs/formats.md has them, in groups of eight with the written widths given.
Bytes codes_of(const std::vector<int>& codes, const std::vector<int>& widths) {
  Bytes low;
  std::vector<bool> bits;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const int width = widths[i / 8] == 15 ? 16 : widths[i / 8];
    if (width > 8) low.push_back(static_cast<std::uint8_t>(codes[i] & 255));
    for (int bit = width - 1; bit >= (width > 8 ? 8 : 0); --bit) bits.push_back((codes[i] >> bit & 1) != 0);
  }
  while (bits.size() % 8 != 0) bits.push_back(false);
  Bytes packed;
  for (std::size_t i = bits.size(); i > 0; i -= 8) {
    int byte = 0;
    for (std::size_t bit = i - 8; bit < i; ++bit) byte = 2 * byte + (bits[bit] ? 1 : 0);
    packed.push_back(static_cast<std::uint8_t>(byte));
  }
  return low + packed;
}

TEST(DepthRecord, CodesOfEveryWidthAndNumber) {
  std::minstd_rand random(3);
  for (int width = 1; width <= 15; ++width) {
    const int bits = width == 15 ? 16 : width;
    for (std::size_t count = 1; count <= 64; ++count) {
      Bytes record{head(16 + width, 3), 0, 0, 0, 0, 0, 0, 0, 0, 0x34, 0x12};
      std::vector<int> codes;
      while (codes.size() < count) {
        record[1 + codes.size() / 8] = static_cast<std::uint8_t>(record[1 + codes.size() / 8] | 1 << codes.size() % 8);
        codes.push_back(static_cast<int>(random() / 64 % (1U << bits)) - (1 << (bits - 1)));
      }
      record = record + codes_of(codes, std::vector<int>(8, width));
      if (record.size() >= 128) continue;  // that would be raw cells
      expect_cells(record, 8, 8, [&](auto x, auto y) { return y * 8 + x < count ? 0x1234 + codes[y * 8 + x] : 0; });
    }
  }
}

TEST(DepthRecord, ResidualsOfEveryWidth) {
  // One code other than 0, in the third cell of row 5: what is predicted from that cell continues it.
  for (const int opcode : {8, 9, 10}) {
    for (int width = 1; width <= 15; ++width) {
      std::vector<int> codes(64), widths(8);
      const int residual = width == 15 ? -32768 : -(1 << (width - 1));
      codes[8 * 5 + 2] = residual;
      widths[5] = width;
      const Bytes record =
          Bytes{head(opcode, 0), 0x00, 0x40, 0, 0, static_cast<std::uint8_t>(width << 4), 0} + codes_of(codes, widths);
      expect_cells(record, 8, 8, [&](std::uint32_t x, std::uint32_t y) {
        const int along = static_cast<int>(x) - 1, down = static_cast<int>(y) - 4;
        if (x < 2 || y < 5) return 0x4000;
        if (opcode == 8) return y == 5 ? 0x4000 + residual * along : 0x4000;  // a row has its slope for itself
        if (opcode == 9) return 0x4000 + residual;
        return x == 2 ? 0x4000 + residual * down : 0x4000;
      });
    }
  }
}

/// Rows with residual 1 in column 1 only: 2 bits a code (00 01 00 00 ...).
Bytes slope_of_one(int opcode, std::uint32_t rows_with_codes) {
  Bytes record{head(opcode, 0), 0xE8, 0x03, 0, 0, 0, 0};
  for (std::uint32_t y = 0; y < rows_with_codes; ++y) {
    record[3 + y / 2] = static_cast<std::uint8_t>(record[3 + y / 2] | 2 << (y % 2 * 4));
    record = record + Bytes{0x00, 0x10};
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
  expect_cells({head(9, 0), 0xF4, 0x01, 0x03, 0, 0, 0x0C}, 1, 8,
               [](auto, auto y) { return 500 + 3 * static_cast<int>(y); });
}

TEST(DepthRecord, LowBytesStandApart) {
  // Row 0: 11 bits, cell 3 is 1000 (0x3E8); row 1: 16 bits, cell 3 is -1000 (0xFC18).
  Bytes record{head(9, 0), 0x64, 0x00, 0xFB, 0, 0, 0};
  record = record + Bytes{0, 0, 0, 0xE8, 0, 0, 0, 0} + Bytes{0, 0, 0, 0x18, 0, 0, 0, 0};
  record = record + Bytes{0, 0, 0, 0, 0xFC, 0, 0, 0} + Bytes{0x00, 0b00110000, 0x00};  // backwards
  // Row 0 continues linearly behind the jump: 100 100 100 1100 2100 ...
  const auto row_0 = [](std::uint32_t x) { return x < 3 ? 100 : 100 + 1000 * static_cast<int>(x - 2); };
  expect_cells(record, 8, 8, [&](auto x, auto y) { return row_0(x) - (y > 0 && x >= 3 ? 1000 : 0); });
}

TEST(DepthRecord, ResidualsOfCoveredCellsOnly) {
  // Trailing cells; uncovered ones are predicted on, and then cleared. Row 0: cells 4..7 = 1000 (codes 0),
  // row 1: cells 6 and 7, + 1 (01 00): six codes of 2 bits.
  const Bytes record{head(9, 2), 0x64, 0x88, 0x88, 0x88, 0xE8, 0x03, 0x02, 0x40, 0x00};
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
  for (const int opcode : {12, 15, 16, 32, 63}) EXPECT_TRUE(refused(Bytes{head(opcode, 0), 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(refused({head(0, 3), 1, 2}));
  EXPECT_TRUE(refused({head(8, 0), 0, 0, 0, 0, 0}));
  EXPECT_TRUE(refused(slope_of_one(8, 2) + Bytes{0}));  // a byte too many
  Bytes short_by_one = slope_of_one(8, 2);
  short_by_one.pop_back();
  EXPECT_TRUE(refused(short_by_one));
  EXPECT_TRUE(refused({head(8, 0), 0, 0, 9, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8}));  // low bytes without the bits above
  EXPECT_TRUE(refused({head(17, 0), 0, 0, 1, 2, 3}));
  EXPECT_TRUE(refused({head(17, 3), 0, 0, 0, 0, 0, 0, 0, 3, 0, 0}));  // covered cells without codes
  EXPECT_TRUE(refused({head(17, 3), 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 1, 2}));
  EXPECT_TRUE(refused(Bytes{head(11, 0)}));
  EXPECT_TRUE(refused(Bytes{head(11, 0), 3 << 6} + Bytes(12, 0)));  // a form that there is not
  for (const unsigned bytes : {4U, 5U, 9U, 12U}) EXPECT_TRUE(refused(Bytes{head(11, 0), 0} + Bytes(bytes, 0))) << bytes;
}

std::vector<std::byte> encoded(const std::vector<std::uint16_t>& cells, std::uint32_t width, std::uint32_t height) {
  std::array<std::byte, kMaxTileRecord> record;
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
  const auto crease = fill([](auto x, auto y) {
    return x + y < 9 ? whole(5000.3 + x * 3.7 - y * 0.11) : whole(5020.3 - x * 5.7 + y * 4.9);
  });
  EXPECT_EQ(opcode_of(crease), 11);
  EXPECT_LE(crease.size(), 22U);
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
    const int crease = x + y < 24 ? plane : whole(9000.5 - x * 9.5 - y * 3.1);
    const int below = x >= 8 && x < 16 && y < 16 ? crease : plane / 2 + noise;
    cells[i] = static_cast<std::uint16_t>(y < 8 ? (x < 8 ? plane : x + y < 20 ? plane : 0) : below);
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
