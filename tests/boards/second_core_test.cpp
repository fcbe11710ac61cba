// Strips drawn by two cores: order, buffers that nobody else touches, errors at every step, a core that does not
// answer; and whole frames with two threads in the cores' place.
#include "zstrip_hal/second_core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "late_display.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::hal {
namespace {

constexpr StripLayout kLayouts[] = {{1, 10}, {2, 5}, {3, 4}, {4, 3}, {5, 2}, {6, 5, 2}, {10, 1}};

/// The second core draws when the first one waits for it, or never.
struct Turn {
  SecondCore<NumberedStrips>* second;
  void wait(std::uint32_t) {
    if (second != nullptr) second->serve();
  }
};

struct Outcome {
  PresentResult<DrawStatus> result;
  std::vector<std::uint16_t> by_first, by_second;
  std::vector<Area> areas;
  std::vector<std::byte> shown;
  bool in_frame = false, is_done = false;
};

Outcome present_in_turns(FailingStep& step, const StripLayout& layout, bool answers = true, std::size_t bytes = 64) {
  NumberedStrips own{step}, other{step};
  LateDisplay display(step);
  SecondCore second(other);
  std::array<std::array<std::byte, 64>, 3> memory{};
  TwoCoreBuffers buffers;
  for (std::size_t i = 0; i < 3; ++i) buffers[i] = std::span(memory[i]).first(bytes);
  Turn clock{answers ? &second : nullptr};
  Outcome outcome;
  outcome.result = present(own, second, display, layout, buffers, clock);
  outcome.by_first = own.drawn, outcome.by_second = other.drawn;
  outcome.areas = display.areas, outcome.shown = display.shown;
  outcome.in_frame = display.in_frame, outcome.is_done = second.is_done();
  return outcome;
}

TEST(SecondCore, EachStripIsDrawnByOneCoreAndArrivesInOrder) {
  for (const StripLayout& layout : kLayouts) {
    FailingStep never;
    const Outcome outcome = present_in_turns(never, layout);
    EXPECT_TRUE(outcome.result);
    std::vector<std::uint16_t> even, odd;
    std::vector<Area> areas;
    std::vector<std::byte> expected;
    const StripAreas places(layout, kWidth, kHeight);
    for (std::uint16_t strip = 0; strip < layout.count; ++strip) {
      (strip % 2 == 0 ? even : odd).push_back(strip);
      const Area area = places.area(strip);
      areas.push_back(area);
      expected.insert(expected.end(), area.width / 2U * area.height, static_cast<std::byte>(strip + 1));
    }
    EXPECT_EQ(outcome.by_first, even);
    EXPECT_EQ(outcome.by_second, odd);
    EXPECT_EQ(outcome.areas, areas);
    EXPECT_EQ(outcome.shown, expected) << layout.count;
    EXPECT_FALSE(outcome.in_frame);
  }
}

TEST(SecondCore, AnErrorAtAnyStepIsReportedWhenBothCoresAreDone) {
  for (const StripLayout& layout : kLayouts) {
    FailingStep counting;
    ASSERT_TRUE(present_in_turns(counting, layout).result);
    for (int at = 0; at < counting.steps; ++at) {
      FailingStep step{.at = at};
      const Outcome outcome = present_in_turns(step, layout);
      EXPECT_FALSE(outcome.result) << "step " << at;
      EXPECT_NE(outcome.result.draw.failed, outcome.result.display == Error::timeout) << "step " << at;
      EXPECT_LT(outcome.result.strip, layout.count) << "step " << at;
      EXPECT_TRUE(outcome.is_done) << "step " << at;
      EXPECT_FALSE(outcome.in_frame) << "step " << at;
    }
  }
}

TEST(SecondCore, ACoreThatDoesNotAnswerIsAnErrorOfItsStrip) {
  FailingStep never;
  const Outcome outcome = present_in_turns(never, {.count = 5, .rows = 2}, false);
  EXPECT_EQ(outcome.result.display, Error::second_core);
  EXPECT_EQ(outcome.result.strip, 1);
  EXPECT_EQ(outcome.areas.size(), 1U);
  EXPECT_FALSE(outcome.is_done);
  EXPECT_FALSE(outcome.in_frame);
}

TEST(SecondCore, WhatCannotBeginIsAnErrorOfDrawingOnce) {
  FailingStep never;
  NumberedStrips own{never}, other{never};
  LateDisplay display(never);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  Turn clock{&second};
  const auto shown = [&] {
    return present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, clock);
  };
  const auto fails = [] { return DrawStatus{true}; };
  second.start(fails);
  const auto refused = shown();
  EXPECT_TRUE(refused.draw.failed);
  EXPECT_EQ(refused.display, Error::none);
  EXPECT_TRUE(display.areas.empty());
  EXPECT_TRUE(shown());
}

TEST(SecondCore, WhatDoesNotFitIsRefused) {
  FailingStep never;
  EXPECT_EQ(present_in_turns(never, {.count = 2, .rows = 4}).result.display, Error::strip_layout);
  EXPECT_EQ(present_in_turns(never, {.count = 3, .rows = 4}, true, 11).result.display, Error::pixels_too_small);
  EXPECT_EQ(never.steps, 0);
}

/// A picture in RGB565.
struct Framebuffer {
  static constexpr std::uint16_t kColumns = 160, kRows = 120;
  std::vector<std::byte> bytes = std::vector<std::byte>(std::size_t{kColumns} * kRows * 2);

  std::uint16_t width() const { return kColumns; }
  std::uint16_t height() const { return kRows; }
  PixelFormat format() const { return PixelFormat::rgb565; }
  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    std::ranges::copy(pixels, bytes.begin() + area.top * kColumns * 2);
    return Error::none;
  }
  Error wait() { return Error::none; }
  Error end_frame() { return Error::none; }
};

struct Sleep {
  void wait(std::uint32_t microseconds) { std::this_thread::sleep_for(std::chrono::microseconds(microseconds)); }
};

TEST(SecondCore, ThreadsDrawThePixelsOfOneCore) {
  constexpr const scenes::BuiltIn& kScene = scenes::knot_meshlets;
  constexpr Effects kEffects = effects_of(kScene.scene, kScene.camera);
  using SceneRenderer = Renderer<kEffects>;
  constexpr View kView{Framebuffer::kColumns, Framebuffer::kRows, zstrip::PixelFormat::rgb565};
  constexpr Plan kPlan = plan(kScene.counts, kView, kEffects, {.strip_rows = 11}).plan;
  alignas(kArenaAlignment) static std::array<std::byte, kPlan.bytes()> arenas[2];
  alignas(4) static std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels[3];
  SceneRenderer own, other;
  SecondCore second(other);
  std::atomic<bool> stops = false;
  std::thread core([&] {
    while (!stops.load()) {
      if (!second.serve()) std::this_thread::yield();
    }
  });
  Sleep clock;
  scenes::Staged staged;
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    scenes::stage(kScene, staged, frame, 12);
    const auto begin = [&] { return other.begin_frame(staged.scene, staged.camera, kView, kPlan, arenas[1]); };
    if (frame % 2 == 0) {
      second.start(begin);
    } else {
      ASSERT_TRUE(begin());
    }
    ASSERT_TRUE(own.begin_frame(staged.scene, staged.camera, kView, kPlan, arenas[0]));
    Framebuffer one, two;
    EXPECT_TRUE(present(own, one, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns}, {pixels[0], {}}));
    EXPECT_TRUE(present(own, second, two, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns},
                        {pixels[0], pixels[1], pixels[2]}, clock));
    EXPECT_EQ(one.bytes, two.bytes) << "frame " << frame;
  }
  stops = true;
  core.join();
}

}  // namespace
}  // namespace zstrip::hal
