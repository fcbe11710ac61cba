// Records of colour, byte by byte, and any pixels there and back.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "zstrip/store/colour_store.hpp"

namespace {

using namespace zstrip;

using Bytes = std::vector<std::uint8_t>;

struct Decoded {
  bool good;
  std::vector<std::uint16_t> pixels;

  Decoded(const Bytes& record, std::uint32_t width, std::uint32_t height) : pixels(width * height, 0xA55A) {
    // A heap buffer of exactly the record's size, so that AddressSanitizer sees every byte too many.
    const std::unique_ptr<std::byte[]> exact(new std::byte[record.size()]);
    for (std::size_t i = 0; i < record.size(); ++i) exact[i] = std::byte{record[i]};
    good = decode_colour_tile({exact.get(), record.size()}, {pixels.data(), width, width, height});
  }
};

void expect_pixels(const Bytes& record, std::uint32_t width, std::uint32_t height,
                   const std::vector<std::uint16_t>& expected) {
  const Decoded decoded(record, width, height);
  EXPECT_TRUE(decoded.good);
  EXPECT_EQ(decoded.pixels, expected);
}

TEST(ColourRecord, HandMade) {
  expect_pixels({}, 3, 1, {0, 0, 0});
  expect_pixels({0x34, 0x12}, 3, 1, {0x1234, 0x1234, 0x1234});
  expect_pixels({1, 2, 3, 4, 5, 6}, 3, 1, {0x0201, 0x0403, 0x0605});
  // Two colours: a bit a pixel, 10110100 1.
  expect_pixels({2, 0x11, 0x11, 0x22, 0x22, 0xB4, 0x80}, 3, 3,
                {0x2222, 0x1111, 0x2222, 0x2222, 0x1111, 0x2222, 0x1111, 0x1111, 0x2222});
  // Three colours: two bits a pixel, 00 01 10 00 01.
  expect_pixels({3, 1, 0, 2, 0, 3, 0, 0x18, 0x40}, 5, 1, {1, 2, 3, 1, 2});
  // Five colours: four bits a pixel.
  expect_pixels({5, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0x01, 0x23, 0x40, 0x12, 0x34}, 5, 2, {1, 2, 3, 4, 5, 1, 2, 3, 4, 5});
  // Differences: 2 bits of red, 2 of green, 1 of blue, from the left, in the first column from above:
  // 00 00 0, 00 01 0, then a literal (10), 01 00 0, 00 11 0, 00 00 1.
  expect_pixels({0x80 | 2 << 3 | 2, 1, 0x05, 0x50, 0x00, 0xA4, 0x18, 0x20, 0x34, 0x12}, 3, 2,
                {0x5005, 0x5025, 0x1234, 0x5805, 0x5FE5, 0x5FE4});
}

TEST(ColourRecord, WrongOnesAreRefused) {
  for (const Bytes& record :
       {Bytes{1, 0, 0}, Bytes{17, 0, 0}, Bytes{2, 0, 0, 1, 1, 0}, Bytes(129, 0), Bytes{0x80, 0, 0, 0},
        Bytes{0x80 | 6 << 3, 0, 0, 0}, Bytes{0x87, 0, 0, 0}, Bytes{0xC9, 0, 0, 0, 0}, Bytes{0x92, 0, 0, 0},
        Bytes{0x92, 6, 0, 0}, Bytes{0x92, 1, 0, 0, 0, 0}}) {
    EXPECT_FALSE(Decoded(record, 8, 8).good);
  }
}

std::vector<std::byte> encoded(const std::vector<std::uint16_t>& pixels, std::uint32_t width, std::uint32_t height) {
  std::array<std::byte, kMaxTileRecord> record;
  const std::uint32_t size = encode_colour_tile({pixels.data(), width, width, height}, record);
  return {record.begin(), record.begin() + size};
}

TEST(ColourEncoder, ChoosesTheKind) {
  const auto size_of = [](const std::function<unsigned(unsigned)>& pixel) {
    std::vector<std::uint16_t> pixels(64);
    for (unsigned i = 0; i < 64; ++i) pixels[i] = static_cast<std::uint16_t>(pixel(i));
    return encoded(pixels, 8, 8).size();
  };
  EXPECT_EQ(size_of([](unsigned) { return 0xABCDU; }), 2U);
  EXPECT_EQ(size_of([](unsigned i) { return i * 7 / 64 % 2; }), 1U + 4 + 8);
  EXPECT_EQ(size_of([](unsigned i) { return i % 4 * 1000; }), 1U + 8 + 16);
  EXPECT_EQ(size_of([](unsigned i) { return i % 16 * 1000; }), 1U + 32 + 32);
  EXPECT_EQ(size_of([](unsigned i) { return 0x0821 * (i % 8 + i / 8 + 3); }), 4U + 48);
  EXPECT_EQ(size_of([](unsigned i) { return (i * 40503 + 77) * 30011 >> 3; }), 128U);
}

TEST(ColourEncoder, AnyPixelsComeBack) {
  std::minstd_rand engine(9);
  const auto below = [&engine](unsigned limit) { return static_cast<unsigned>(engine() >> 8) % limit; };
  for (int round = 0; round < 20000; ++round) {
    const unsigned width = 1 + below(8), height = 1 + below(8), kind = below(4), spread = 1 + below(40);
    std::vector<std::uint16_t> pixels(width * height);
    unsigned last = below(65536);
    for (auto& pixel : pixels) {
      if (kind == 0) last = below(65536);
      if (kind == 1) last += below(3) * 0x0800 + below(3) * 0x20 + below(3) - 0x0821;
      pixel = static_cast<std::uint16_t>(kind == 2 ? below(spread) * 1237 : last);
    }
    const std::vector<std::byte> record = encoded(pixels, width, height);
    ASSERT_LE(record.size(), 2 * pixels.size());
    std::vector<std::uint16_t> decoded(pixels.size());
    ASSERT_TRUE(decode_colour_tile(record, {decoded.data(), width, width, height}));
    ASSERT_EQ(decoded, pixels);
  }
}

TEST(ColourStore, KeepsAPictureAndItsBlob) {
  std::vector<std::uint16_t> pixels(50 * 30);
  for (unsigned i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<std::uint16_t>(i % 50 / 7 * 0x0821 + i / 400 * 9);
  std::vector<std::byte> pool(store_bytes_worst(50, 30));
  ColourStore store;
  ASSERT_TRUE(store.reset(pool, 50, 30));
  ASSERT_TRUE(store.write_rows({pixels.data(), 50, 0, 30}));
  const auto blob = store.blob();
  EXPECT_LT(blob.size(), 1000U);
  ColourReader reader;
  ASSERT_TRUE(reader.open(blob));
  EXPECT_TRUE(reader.validate());
  std::vector<std::uint16_t> read(pixels.size());
  ASSERT_TRUE(reader.read_rows({read.data(), 50, 0, 30}));
  EXPECT_EQ(read, pixels);
}

}  // namespace
