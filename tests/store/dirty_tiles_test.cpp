// Dirty tiles: exactly the tiles that were touched, each once, in few rectangles.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

#include "zstrip/store/dirty_tiles.hpp"

namespace {

using namespace zstrip;

struct Layer {
  std::vector<std::uint32_t> words;
  DirtyTiles tiles;

  Layer(std::uint32_t width, std::uint32_t height) : words(dirty_tile_words(width, height), 0xFFFFFFFF) {
    EXPECT_TRUE(tiles.reset(words, width, height));
  }
  std::vector<Rect> take_all() {
    std::vector<Rect> rects;
    for (Rect rect; tiles.take(rect);) rects.push_back(rect);
    return rects;
  }
};

TEST(DirtyTiles, NoneAtFirst) { EXPECT_TRUE(Layer(320, 240).take_all().empty()); }

TEST(DirtyTiles, OneRectangleComesBackOnWholeTiles) {
  Layer layer(100, 60);
  layer.tiles.mark({9, 17, 24, 25});
  EXPECT_TRUE(layer.tiles.marked(1, 2));
  EXPECT_FALSE(layer.tiles.marked(3, 2));
  EXPECT_EQ(layer.take_all(), (std::vector<Rect>{{8, 16, 24, 32}}));
  EXPECT_TRUE(layer.take_all().empty());
}

TEST(DirtyTiles, CutsAtTheBorders) {
  Layer layer(100, 60);
  layer.tiles.mark({-50, -50, 1000, 1000});
  EXPECT_EQ(layer.take_all(), (std::vector<Rect>{{0, 0, 100, 60}}));
  layer.tiles.mark({-50, 0, 0, 60});
  layer.tiles.mark({100, 0, 120, 60});
  layer.tiles.mark({30, 30, 30, 60});
  layer.tiles.mark({40, 40, 30, 60});
  EXPECT_TRUE(layer.take_all().empty());
  layer.tiles.mark({99, 59, 100, 60});
  EXPECT_EQ(layer.take_all(), (std::vector<Rect>{{96, 56, 100, 60}}));
}

// A thing that moves by a few pixels: the old and the new rectangle are three rectangles of tiles at most.
TEST(DirtyTiles, AMoveIsAFewRectangles) {
  Layer layer(320, 240);
  layer.tiles.mark({100, 100, 160, 160});
  layer.tiles.mark({110, 110, 170, 170});
  EXPECT_EQ(layer.take_all(), (std::vector<Rect>{{96, 96, 160, 104}, {96, 104, 176, 160}, {104, 160, 176, 176}}));
}

TEST(DirtyTiles, SidesThatAreNot) {
  Layer layer(8, 8);
  EXPECT_EQ(layer.tiles.reset(layer.words, 0, 8).error, Error::view_size);
  EXPECT_EQ(layer.tiles.reset(layer.words, 8, 4097).error, Error::view_size);
  const Status status = layer.tiles.reset(layer.words, 8, 9);
  EXPECT_EQ(status.error, Error::store_full);
  EXPECT_EQ(status.needed, 8U);
  EXPECT_EQ(status.available, 4U);
  layer.tiles.mark({0, 0, 8, 8});
  EXPECT_TRUE(layer.take_all().empty());
}

// Against a set of tiles, with widths around the limits of words.
TEST(DirtyTiles, EachTouchedTileExactlyOnce) {
  std::minstd_rand engine(3);
  const auto below = [&engine](int limit) { return static_cast<int>(engine() >> 8) % limit; };
  for (int round = 0; round < 2000; ++round) {
    const int width = 1 + below(600), height = 1 + below(80);
    Layer layer(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    std::set<std::pair<int, int>> expected;
    for (int i = below(5); i > 0; --i) {
      const int left = below(width + 40) - 20, top = below(height + 40) - 20;
      const Rect rect{left, top, left + below(300), top + below(60)};
      layer.tiles.mark(rect);
      for (int y = std::max(top, 0); y < std::min(rect.bottom, height); ++y) {
        for (int x = std::max(left, 0); x < std::min(rect.right, width); ++x) expected.insert({x / 8, y / 8});
      }
    }
    std::set<std::pair<int, int>> found;
    for (const Rect& rect : layer.take_all()) {
      ASSERT_FALSE(rect.empty());
      ASSERT_TRUE(rect.right <= width && rect.bottom <= height);
      for (int ty = rect.top / 8; ty * 8 < rect.bottom; ++ty) {
        for (int tx = rect.left / 8; tx * 8 < rect.right; ++tx) ASSERT_TRUE(found.insert({tx, ty}).second);
      }
    }
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
