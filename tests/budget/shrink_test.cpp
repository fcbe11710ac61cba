// Memory byte by byte: whatever size arena, strip of pixels, plan or budget have, the picture is right or an error says
// how many bytes are needed; and with exactly so many it is right. Nothing outside the memory is touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "guarded_memory.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::budget {
namespace {

using Bytes = std::vector<std::byte>;

/// A scene in a small picture whose rows fill no whole number of bytes in any format.
struct Case {
  std::string name;
  const scenes::BuiltIn& built_in;
  View view;
  scenes::Staged staged;
  Effects effects;

  Case(const scenes::BuiltIn& scene, const View& picture)
      : name(std::string(scene.name) + ", format " + std::to_string(static_cast<int>(picture.format))),
        built_in(scene),
        view(picture),
        effects(effects_of(scene.scene, scene.camera) | effect::bins) {
    stage(scene, staged, 1, 12, view);
  }
  PlanResult plan(const zstrip::Budget& budget) const { return zstrip::plan(built_in.counts, view, effects, budget); }
  Status begin(AnyRenderer& renderer, const Plan& plan, std::span<std::byte> arena) const {
    return renderer.begin_frame(staged.scene, staged.camera, view, plan, arena);
  }
  std::uint32_t bytes_of(const Rect& area) const {
    return static_cast<std::uint32_t>(area.height()) * row_bytes(area.width());
  }
  std::uint32_t row_bytes(std::int32_t width) const {
    return bytes_per_row(static_cast<std::uint16_t>(width), view.format);
  }
};

/// Under AddressSanitizer, which checks each piece of memory, two formats with each scene; with ZSTRIP_LONG all.
void for_each_case(const std::function<void(const Case&)>& test) {
  constexpr std::array kFormats{PixelFormat::rgb565,  PixelFormat::rgb565_swapped, PixelFormat::gray4,
                                PixelFormat::mono,    PixelFormat::rgb666,         PixelFormat::rgb444,
                                PixelFormat::xrgb8888};
  const bool few = GuardedMemory::traps_access_outside() && std::getenv("ZSTRIP_LONG") == nullptr;
  const std::size_t formats = few ? 2 : kFormats.size();
  std::size_t next = 0;
  for (const char* name : {"triangle", "cube", "room", "teapot_meshlets", "knot_textured"}) {
    for (std::size_t i = 0; i < formats; ++i) {
      const scenes::BuiltIn* const scene = scenes::find(name);
      ASSERT_NE(scene, nullptr) << name;
      const Case each(*scene, {21, 13, kFormats[next++ % kFormats.size()]});
      SCOPED_TRACE(each.name);
      test(each);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

/// The picture, drawn in exactly the memory that the plan asks for. Empty after a failure.
Bytes draw(const Case& each, const Plan& plan) {
  GuardedMemory arena(plan.bytes());
  AnyRenderer renderer(each.effects);
  const Status begun = each.begin(renderer, plan, arena.bytes());
  EXPECT_TRUE(begun) << message(begun.error);
  Bytes picture(each.bytes_of({0, 0, each.view.width, each.view.height}));
  for (std::uint16_t strip = 0; begun && strip < plan.strips; ++strip) {
    // The last strips may be smaller, and need no more than their pixels.
    const Rect area = plan.strip_area(strip, each.view);
    GuardedMemory pixels(each.bytes_of(area));
    const Status drawn = renderer.draw_strip(strip, pixels.bytes());
    EXPECT_TRUE(drawn) << message(drawn.error);
    EXPECT_TRUE(pixels.guards_untouched());
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      std::copy_n(
          pixels.bytes().data() + static_cast<std::uint32_t>(y - area.top) * each.row_bytes(area.width()),
          each.row_bytes(area.width()),
          picture.data() + static_cast<std::uint32_t>(y) * each.row_bytes(each.view.width) + each.row_bytes(area.left));
    }
  }
  EXPECT_TRUE(arena.guards_untouched());
  return picture;
}

/// Drawn in one strip, in as much memory as it takes.
Bytes reference(const Case& each) {
  const auto [status, plan] = each.plan({.modes = Modes::streamed});
  EXPECT_TRUE(status);
  EXPECT_EQ(plan.strips, 1);
  const Bytes picture = draw(each, plan);
  EXPECT_GT(std::set<std::byte>(picture.begin(), picture.end()).size(), 1U) << "a picture of nothing proves nothing";
  return picture;
}

TEST(Budget, ArenaOfEverySize) {
  for_each_case([](const Case& each) {
    const Bytes expected = reference(each);
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{13, 4, 1}) {
      const Plan plan = each.plan({.strip_rows = rows}).plan;
      EXPECT_EQ(draw(each, plan), expected) << rows;
      for (std::uint32_t size = 0; size < plan.bytes(); ++size) {
        GuardedMemory arena(size), pixels(plan.strip_pixel_bytes(each.view));
        AnyRenderer renderer(each.effects);
        const Status status = each.begin(renderer, plan, arena.bytes());
        ASSERT_EQ(status.error, Error::arena_too_small) << size;
        ASSERT_EQ(status.needed, plan.bytes());
        ASSERT_EQ(status.available, size);
        ASSERT_EQ(renderer.draw_strip(0, pixels.bytes()).error, Error::not_begun);
        ASSERT_TRUE(arena.untouched() && pixels.untouched()) << size;
      }
    }
  });
}

TEST(Budget, ArenaAtEveryAddress) {
  for_each_case([](const Case& each) {
    const Plan plan = each.plan({.strip_rows = 4}).plan;
    for (std::size_t misalignment = 1; misalignment < kArenaAlignment; ++misalignment) {
      GuardedMemory arena(plan.bytes(), misalignment);
      AnyRenderer renderer(each.effects);
      ASSERT_FALSE(each.begin(renderer, plan, arena.bytes())) << misalignment;
      ASSERT_TRUE(arena.untouched()) << misalignment;
    }
  });
}

TEST(Budget, PixelsOfEverySize) {
  for_each_case([](const Case& each) {
    const Plan plan = each.plan({.strip_rows = 4}).plan;
    GuardedMemory arena(plan.bytes());
    AnyRenderer renderer(each.effects);
    ASSERT_TRUE(each.begin(renderer, plan, arena.bytes()));
    for (std::uint16_t strip = 0; strip < plan.strips; ++strip) {
      const std::uint32_t needed = each.bytes_of(plan.strip_area(strip, each.view));
      for (std::uint32_t size = 0; size < needed; ++size) {
        GuardedMemory pixels(size);
        const Status status = renderer.draw_strip(strip, pixels.bytes());
        ASSERT_EQ(status.error, Error::pixels_too_small) << size;
        ASSERT_EQ(status.needed, needed);
        ASSERT_EQ(status.available, size);
        ASSERT_TRUE(pixels.untouched()) << size;
      }
    }
    // A refused strip harms nothing: the frame goes on.
    GuardedMemory pixels(plan.strip_pixel_bytes(each.view));
    EXPECT_TRUE(renderer.draw_strip(0, pixels.bytes()));
    EXPECT_TRUE(pixels.guards_untouched() && arena.guards_untouched());
  });
}

TEST(Budget, PixelsAtAnOddAddress) {
  for_each_case([](const Case& each) {
    const Plan plan = each.plan({}).plan;
    GuardedMemory arena(plan.bytes()), pixels(plan.strip_pixel_bytes(each.view), 1);
    AnyRenderer renderer(each.effects);
    ASSERT_TRUE(each.begin(renderer, plan, arena.bytes()));
    const Status status = renderer.draw_strip(0, pixels.bytes());
    if (each.view.format != PixelFormat::rgb565 && each.view.format != PixelFormat::rgb565_swapped) {
      ASSERT_TRUE(status) << message(status.error);
      EXPECT_EQ(Bytes(pixels.bytes().begin(), pixels.bytes().end()), reference(each));
      EXPECT_TRUE(pixels.guards_untouched());
    } else {
      EXPECT_EQ(status.error, Error::pixels_misaligned);
      EXPECT_TRUE(pixels.untouched());
    }
  });
}

/// Plans from elsewhere, or for another scene: a part that is too small for what it holds.
TEST(Budget, EveryPartOfAPlanOfEverySize) {
  for_each_case([](const Case& each) {
    const Bytes expected = reference(each);
    const Plan right = each.plan({.strip_rows = 4, .strip_columns = 16, .modes = Modes::binned}).plan;
    for (const auto& [purpose, part] :
         {std::pair{Purpose::instances, &Plan::instance_bytes}, std::pair{Purpose::extents, &Plan::extent_bytes},
          std::pair{Purpose::vertices, &Plan::vertex_bytes}, std::pair{Purpose::depth, &Plan::depth_bytes},
          std::pair{Purpose::colour, &Plan::colour_bytes}, std::pair{Purpose::bins, &Plan::bin_bytes}}) {
      for (std::uint32_t bytes = 0; bytes < right.*part; ++bytes) {
        Plan plan = right;
        // Beyond the lists themselves, any memory for triangles will do: full lists only make the frame streamed.
        if (purpose == Purpose::bins && bytes % kArenaAlignment == 0 &&
            bytes >= each.built_in.counts.meshlets * kBatchBytes + right.strips * kBinBytes) {
          plan.bin_bytes = bytes;
          ASSERT_EQ(draw(each, plan), expected) << bytes;
          continue;
        }
        plan.*part = bytes;
        GuardedMemory arena(plan.bytes());
        AnyRenderer renderer(each.effects);
        const Status status = each.begin(renderer, plan, arena.bytes());
        ASSERT_EQ(status.error, Error::arena_too_small) << name(purpose) << ' ' << bytes;
        ASSERT_EQ(status.purpose, purpose) << bytes;
        ASSERT_GT(status.needed, bytes);
        ASSERT_LE(status.needed, right.*part);
        ASSERT_EQ(status.available, bytes);
        ASSERT_TRUE(arena.untouched());
      }
    }
    EXPECT_EQ(draw(each, right), expected);
  });
}

TEST(Budget, PlanOfEveryBudget) {
  for_each_case([](const Case& each) {
    const Bytes expected = reference(each);
    for (const bool split : {false, true}) {
      const std::uint32_t whole = each.plan({}).plan.bytes();
      int drawn_plans = 0;
      std::uint64_t least_cost = UINT64_MAX;
      for (std::uint32_t bytes = 1; bytes <= whole + 2 * kArenaAlignment; ++bytes) {
        const auto [status, plan] = each.plan({.bytes = bytes, .split_columns = split});
        if (status) {
          ASSERT_LE(plan.bytes(), bytes);
          const std::uint64_t cost = estimated_cost(each.built_in.counts, each.effects, each.view, plan);
          ASSERT_LE(cost, least_cost) << "more memory, slower: " << bytes;
          if (cost == least_cost) continue;
          least_cost = cost;
          ++drawn_plans;
          ASSERT_EQ(draw(each, plan), expected) << bytes;
          continue;
        }
        ASSERT_EQ(drawn_plans, 0) << "less memory was enough: " << bytes;
        ASSERT_EQ(status.error, Error::arena_too_small);
        ASSERT_EQ(status.available, bytes);
        ASSERT_GT(status.needed, bytes);
        ASSERT_TRUE(each.plan({.bytes = status.needed, .split_columns = split}).status);
        ASSERT_FALSE(each.plan({.bytes = status.needed - 1, .split_columns = split}).status);
      }
      EXPECT_GT(drawn_plans, 3);
    }
  });
}

TEST(Budget, PlanOfEveryBudgetWithGivenRows) {
  for_each_case([](const Case& each) {
    const Bytes expected = reference(each);
    for (std::uint16_t rows = 1; rows <= each.view.height; ++rows) {
      const std::uint32_t needed = each.plan({.strip_rows = rows, .modes = Modes::streamed}).plan.bytes();
      for (std::uint32_t bytes = 1; bytes < needed; ++bytes) {
        const Status status = each.plan({.bytes = bytes, .strip_rows = rows}).status;
        ASSERT_EQ(status.error, Error::arena_too_small);
        ASSERT_EQ(status.needed, needed);
        ASSERT_EQ(status.available, bytes);
      }
      const auto [status, plan] = each.plan({.bytes = needed, .strip_rows = rows});
      ASSERT_TRUE(status);
      EXPECT_EQ(plan.strip_rows, rows);
      EXPECT_EQ(draw(each, plan), expected) << rows;
    }
  });
}

/// The guards themselves.
TEST(Budget, GuardsNoticeAccess) {
  for (const std::size_t size : {0U, 1U, 7U, 8U, 100U}) {
    GuardedMemory memory(size);
    ASSERT_EQ(memory.bytes().size(), size);
    EXPECT_TRUE(memory.untouched());
    if (size == 0) continue;
    for (std::byte& byte : memory.bytes()) byte = std::byte{0};
    EXPECT_FALSE(memory.untouched());
    EXPECT_TRUE(memory.guards_untouched());
  }
  for (const std::ptrdiff_t outside : {-1, 8}) {
    GuardedMemory memory(8);
    volatile std::byte* const byte = memory.bytes().data() + outside;
    if (GuardedMemory::traps_access_outside()) {
      EXPECT_DEATH(*byte = std::byte{0}, "use-after-poison");
    } else {
      *byte = std::byte{0};
      EXPECT_FALSE(memory.guards_untouched());
    }
  }
}

}  // namespace
}  // namespace zstrip::budget
