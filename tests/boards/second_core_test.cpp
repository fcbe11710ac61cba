// Strips drawn by two cores: order, buffers that nothing else touches, errors at every step, a core that does not
// answer.
#include "zstrip_hal/second_core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <thread>
#include <vector>

#include "late_display.hpp"
#include "second_core_thread.hpp"

namespace zstrip::hal {
namespace {

constexpr StripLayout kLayouts[] = {{1, 10}, {2, 5}, {3, 4}, {4, 3}, {5, 2}, {6, 5, 2}, {10, 1}};

/// The cores in one thread: while the first one draws, is in the display or waits, the second one does some things.
class Turns {
 public:
  /// `pattern`: two bits for each time, how many things; when they are used up they begin again.
  explicit Turns(std::uint32_t pattern) : pattern_(pattern) {}
  std::function<void()> serve;
  void pass() {
    if (inside_) return;
    inside_ = true;
    for (std::uint32_t times = pattern_ >> (2 * (turn_++ % kTurns)) & 3U; times > 0; --times) serve();
    inside_ = false;
  }
  static constexpr std::uint32_t kTurns = 5;

 private:
  std::uint32_t pattern_;
  std::uint32_t turn_ = 0;
  bool inside_ = false;
};

struct StripsInTurns {
  NumberedStrips strips;
  Turns* turns = nullptr;
  DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    if (turns != nullptr) turns->pass();
    const DrawStatus status = strips.draw_strip(strip, pixels);
    if (turns != nullptr) turns->pass();
    return status;
  }
};

class DisplayInTurns : public LateDisplay {
 public:
  DisplayInTurns(FailingStep& step, Turns& turns) : LateDisplay(step), turns_(turns) {}
  Error write(const Area& area, std::span<const std::byte> pixels) {
    turns_.pass();
    return LateDisplay::write(area, pixels);
  }
  Error wait() {
    turns_.pass();
    return LateDisplay::wait();
  }

 private:
  Turns& turns_;
};

/// Lets the second core do one thing more, or not.
struct ClockInTurns {
  Turns* turns;
  void wait(std::uint32_t) {
    if (turns != nullptr) turns->pass(), turns->serve();
  }
};

struct Outcome {
  PresentResult<DrawStatus> result;
  std::vector<std::uint16_t> by_first, by_second;
  std::vector<Area> areas;
  std::vector<std::byte> shown;
  bool in_frame = false, is_done = false;
};

Outcome present_in_turns(FailingStep& step, const StripLayout& layout, std::uint32_t pattern, std::size_t bytes = 64) {
  Turns turns(pattern);
  StripsInTurns own{{step}, &turns}, other{{step}};
  DisplayInTurns display(step, turns);
  SecondCore second(other);
  turns.serve = [&second] { second.serve(); };
  std::array<std::array<std::byte, 64>, 3> memory{};
  TwoCoreBuffers buffers;
  for (std::size_t i = 0; i < 3; ++i) buffers[i] = std::span(memory[i]).first(bytes);
  ClockInTurns clock{&turns};
  Outcome outcome;
  outcome.result = present(own, second, display, layout, buffers, clock);
  outcome.by_first = own.strips.drawn, outcome.by_second = other.strips.drawn;
  outcome.areas = display.areas, outcome.shown = display.shown;
  outcome.in_frame = display.in_frame, outcome.is_done = second.is_done();
  return outcome;
}

constexpr std::uint32_t kPatterns = 1U << (2 * Turns::kTurns);

TEST(SecondCore, EachStripIsDrawnOnceAndArrivesInOrder) {
  for (const StripLayout& layout : kLayouts) {
    std::vector<Area> areas;
    std::vector<std::byte> expected;
    const StripAreas places(layout, kWidth, kHeight);
    for (std::uint16_t strip = 0; strip < layout.count; ++strip) {
      const Area area = places.area(strip);
      areas.push_back(area);
      expected.insert(expected.end(), area.width / 2U * area.height, static_cast<std::byte>(strip + 1));
    }
    std::set<std::vector<std::uint16_t>> shares;
    for (std::uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
      FailingStep never;
      const Outcome outcome = present_in_turns(never, layout, pattern);
      ASSERT_TRUE(outcome.result);
      std::vector<std::uint16_t> all = outcome.by_first;
      all.insert(all.end(), outcome.by_second.begin(), outcome.by_second.end());
      std::ranges::sort(all);
      ASSERT_EQ(all.size(), layout.count) << pattern;
      for (std::uint16_t strip = 0; strip < layout.count; ++strip) ASSERT_EQ(all[strip], strip) << pattern;
      ASSERT_EQ(outcome.areas, areas) << pattern;
      ASSERT_EQ(outcome.shown, expected) << layout.count << " strips, " << pattern;
      ASSERT_FALSE(outcome.in_frame);
      ASSERT_TRUE(outcome.is_done);
      shares.insert(outcome.by_second);
    }
    // With the first core drawing one of them at least, as the second one only works in its turns.
    EXPECT_GE(shares.size(), layout.count) << layout.count;
  }
}

TEST(SecondCore, AnErrorAtAnyStepIsReportedWhenBothCoresAreDone) {
  for (const StripLayout& layout : kLayouts) {
    for (std::uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
      FailingStep counting;
      ASSERT_TRUE(present_in_turns(counting, layout, pattern).result);
      for (int at = 0; at < counting.steps; ++at) {
        FailingStep step{.at = at};
        const Outcome outcome = present_in_turns(step, layout, pattern);
        ASSERT_FALSE(outcome.result) << "step " << at << ", " << pattern;
        ASSERT_NE(outcome.result.draw.failed, outcome.result.display == Error::timeout) << "step " << at;
        ASSERT_LT(outcome.result.strip, layout.count) << "step " << at;
        ASSERT_TRUE(outcome.is_done) << "step " << at;
        ASSERT_FALSE(outcome.in_frame) << "step " << at;
      }
    }
  }
}

/// No time passes in it.
struct NoTurn {
  void wait(std::uint32_t) {}
};

TEST(SecondCore, OneThatDoesNotAnswerIsAnErrorOfAWholeFrame) {
  FailingStep never;
  NumberedStrips own{never}, other{never};
  LateDisplay display(never);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  NoTurn clock;
  const auto shown = [&] {
    return present(own, second, display, {.count = 5, .rows = 2}, {memory[0], memory[1], memory[2]}, clock);
  };
  EXPECT_EQ(shown().display, Error::second_core);
  EXPECT_EQ(display.areas.size(), 5U);
  EXPECT_FALSE(second.is_done());
  EXPECT_FALSE(display.in_frame);
  // It is not asked for more before it has done that.
  const auto begin = [] { return DrawStatus{}; };
  second.start(begin);
  EXPECT_EQ(shown().display, Error::second_core);
  EXPECT_EQ(shown().display, Error::second_core);
  EXPECT_EQ(display.areas.size(), 5U);
  while (second.serve()) {
  }
  EXPECT_TRUE(second.is_done());
  EXPECT_EQ(other.drawn.size(), 0U);
}

TEST(SecondCore, WhatCannotBeginIsAnErrorOfDrawingOnce) {
  FailingStep never;
  Turns turns(0x155);
  StripsInTurns own{{never}, &turns}, other{{never}};
  LateDisplay display(never);
  SecondCore second(other);
  turns.serve = [&second] { second.serve(); };
  std::array<std::byte, 64> memory[3];
  ClockInTurns clock{&turns};
  const auto shown = [&] {
    return present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, clock);
  };
  const auto fails = [] { return DrawStatus{true}; };
  second.start(fails);
  const auto refused = shown();
  EXPECT_TRUE(refused.draw.failed);
  EXPECT_EQ(refused.display, Error::none);
  EXPECT_TRUE(other.strips.drawn.empty());
  EXPECT_TRUE(shown());
}

TEST(SecondCore, WhatDoesNotFitIsRefused) {
  FailingStep never;
  EXPECT_EQ(present_in_turns(never, {.count = 2, .rows = 4}, 0).result.display, Error::strip_layout);
  EXPECT_EQ(present_in_turns(never, {.count = 3, .rows = 4}, 0, 11).result.display, Error::pixels_too_small);
  EXPECT_EQ(never.steps, 0);
}

/// Draws when it may, and says when it is asked to.
struct HeldStrips {
  std::atomic<bool>* waits_for;
  std::atomic<bool>* asked;
  std::vector<std::uint16_t> drawn{};
  DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    asked->store(true);
    while (!waits_for->load()) std::this_thread::yield();
    std::ranges::fill(pixels, static_cast<std::byte>(strip + 1));
    drawn.push_back(strip);
    return {};
  }
};

TEST(SecondCore, OneThatKeepsAStripIsAnErrorOfThatAndGoesOnLater) {
  std::atomic<bool> is_free = false, is_taken = false, is_own_asked = false;
  HeldStrips own{&is_taken, &is_own_asked}, other{&is_free, &is_taken};
  FailingStep never;
  LateDisplay display(never);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  NoTurn clock;
  const auto shown = [&] {
    return present(own, second, display, {.count = 5, .rows = 2}, {memory[0], memory[1], memory[2]}, clock);
  };
  const Thread thread(second);
  const auto late = shown();
  EXPECT_EQ(late.display, Error::second_core);
  EXPECT_LT(late.strip, 2);  // either core can be the one with the first strip
  EXPECT_EQ(display.areas.size(), late.strip);
  // Until then the first core has drawn what there are buffers for.
  EXPECT_EQ(own.drawn, late.strip == 0 ? (std::vector<std::uint16_t>{1, 2}) : (std::vector<std::uint16_t>{0, 2, 3}));
  EXPECT_FALSE(second.is_done());
  EXPECT_FALSE(display.in_frame);
  is_free = true;
  while (!second.is_done()) std::this_thread::yield();
  display.areas.clear();
  Sleep sleep;
  EXPECT_TRUE(present(own, second, display, {.count = 5, .rows = 2}, {memory[0], memory[1], memory[2]}, sleep));
  EXPECT_EQ(display.areas.size(), 5U);
}

TEST(SecondCore, OneThatIsSlowWithEachStripIsWaitedFor) {
  /// Its time passes while the second core draws, and stands still when that is late.
  struct CountingClock {
    std::atomic<std::uint32_t> waits_left = 0;
    void wait(std::uint32_t) {
      if (waits_left > 0) {
        --waits_left;
      } else {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      }
    }
  } clock;
  struct Slow {
    CountingClock* clock;
    std::uint32_t waits;
    std::atomic<bool>* is_taken;
    DrawStatus draw_strip(std::uint16_t, std::span<std::byte>) {
      clock->waits_left += waits;
      if (waits > 0) is_taken->store(true);
      while (!is_taken->load() || (waits > 0 && clock->waits_left > 0)) std::this_thread::yield();
      return {};
    }
  };
  std::atomic<bool> is_taken = false;
  Slow own{&clock, 0, &is_taken}, other{&clock, 300'000, &is_taken};
  FailingStep never;
  LateDisplay display(never);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  const Thread thread(second);
  EXPECT_TRUE(present(own, second, display, {10, 1}, {memory[0], memory[1], memory[2]}, clock));
}

TEST(SecondCore, WhatItBeganIsWaitedForWhenTheDisplayFails) {
  FailingStep first{.at = 0};
  NumberedStrips own{first}, other{first};
  LateDisplay display(first);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  bool begun = false;
  const auto begin = [&] {
    begun = true;
    return DrawStatus{};
  };
  second.start(begin);
  Turns turns(0);
  turns.serve = [&second] { second.serve(); };
  ClockInTurns clock{&turns};
  EXPECT_EQ(present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, clock).display,
            Error::timeout);
  EXPECT_TRUE(begun);
  first.steps = 0;
  second.start(begin);
  NoTurn never;
  EXPECT_EQ(present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, never).display,
            Error::second_core);
}

TEST(SecondCore, AFailedBeginIsReportedWithTheFrameThatIsNotDrawn) {
  FailingStep step;
  NumberedStrips own{step}, other{step};
  LateDisplay display(step);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  Turns turns(0);
  turns.serve = [&second] { second.serve(); };
  ClockInTurns clock{&turns};
  const auto fails = [] { return DrawStatus{true}; };
  const auto shown = [&](const StripLayout& layout) {
    return present(own, second, display, layout, {memory[0], memory[1], memory[2]}, clock);
  };
  for (const bool fits : {true, false}) {
    step = {.at = fits ? 0 : -1};
    second.start(fails);
    const auto refused = shown(fits ? kLayouts[1] : StripLayout{.count = 2, .rows = 4});
    EXPECT_TRUE(refused.draw.failed);
    EXPECT_EQ(refused.display, fits ? Error::timeout : Error::strip_layout);
    // The next frame, which start() does not begin, has no part in that error.
    EXPECT_TRUE(shown(kLayouts[1]));
  }
}

TEST(SecondCore, ABeginThatFailsAfterItsFrameTimedOutIsNoErrorOfTheNextFrame) {
  FailingStep step{.at = 0};
  NumberedStrips own{step}, other{step};
  LateDisplay display(step);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  const auto shown = [&](auto clock) {
    return present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, clock);
  };
  const auto fails = [] { return DrawStatus{true}; };
  second.start(fails);
  EXPECT_EQ(shown(NoTurn{}).display, Error::second_core);
  while (second.serve()) {
  }
  Turns turns(0);
  turns.serve = [&second] { second.serve(); };
  EXPECT_TRUE(shown(ClockInTurns{&turns}));
}

TEST(SecondCore, OneThatDoesNotAnswerAfterAnErrorIsNamedNextToIt) {
  FailingStep step{.at = 1};  // the first core's first strip
  NumberedStrips own{step}, other{step};
  LateDisplay display(step);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  NoTurn clock;
  const auto late = present(own, second, display, kLayouts[1], {memory[0], memory[1], memory[2]}, clock);
  EXPECT_TRUE(late.draw.failed);
  EXPECT_EQ(late.display, Error::second_core) << "it still has its buffer";
  EXPECT_FALSE(second.is_done());
}

TEST(SecondCore, OneThatStaysInTheDisplayKeepsIt) {
  struct Held {
    std::atomic<bool> is_taken = false, is_further = false, is_inside = false, is_free = false;
    static void wait(const std::atomic<bool>& flag) {
      while (!flag) std::this_thread::yield();
    }
  } held;
  struct Display : LateDisplay {
    Display(FailingStep& step, Held& of) : LateDisplay(step), held(of) {}
    Error write(const Area& area, std::span<const std::byte> pixels) {
      if (std::this_thread::get_id() != first) {
        held.is_inside = true;
        Held::wait(held.is_free);
      }
      return LateDisplay::write(area, pixels);
    }
    Held& held;
    std::thread::id first = std::this_thread::get_id();
  };
  // The second core has one of the first two strips, and the first one draws on while that is sent.
  struct Strips {
    Held& held;
    std::thread::id first = std::this_thread::get_id();
    DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte>) {
      if (std::this_thread::get_id() != first) {
        held.is_taken = true;
        Held::wait(held.is_further);
      } else if (strip == 0) {
        Held::wait(held.is_taken);
      } else {
        held.is_further = true;
        Held::wait(held.is_inside);
      }
      return {};
    }
  };
  FailingStep never;
  Strips own{held}, other{held};
  Display display(never, held);
  SecondCore second(other);
  std::array<std::byte, 64> memory[3];
  const Thread thread(second);
  NoTurn clock;
  const auto late = present(own, second, display, {5, 2}, {memory[0], memory[1], memory[2]}, clock);
  EXPECT_EQ(late.display, Error::second_core);
  EXPECT_LT(late.strip, 2);
  EXPECT_TRUE(display.in_frame);
  EXPECT_FALSE(second.is_done());
  held.is_free = true;
  while (!second.is_done()) std::this_thread::yield();
  EXPECT_EQ(display.areas.size(), late.strip + 1U);
}

/// Strips of unequal work.
struct UnequalStrips {
  std::uint32_t frame = 0;
  std::uint32_t drawn = 0;
  DrawStatus draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    const std::chrono::nanoseconds work((strip * 2654435761U ^ frame * 40503U) % 8000);
    const auto end = std::chrono::steady_clock::now() + work;
    while (std::chrono::steady_clock::now() < end) {
    }
    std::ranges::fill(pixels, static_cast<std::byte>(strip + 1));
    ++drawn;
    return {};
  }
};

/// Checks that one thread at a time is in it.
class LonelyDisplay : public LateDisplay {
 public:
  using LateDisplay::LateDisplay;
  Error write(const Area& area, std::span<const std::byte> pixels) {
    const Visit visit(visitors_);
    return LateDisplay::write(area, pixels);
  }
  Error wait() {
    const Visit visit(visitors_);
    return LateDisplay::wait();
  }

 private:
  struct Visit {
    explicit Visit(std::atomic<int>& visitors) : count(visitors) { EXPECT_EQ(count.fetch_add(1), 0); }
    ~Visit() { count.fetch_sub(1); }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    std::atomic<int>& count;
  };
  std::atomic<int> visitors_ = 0;
};

TEST(SecondCore, ThreadsDrawStripsOfUnequalWorkInOrder) {
  constexpr StripLayout kLayout{10, 1};
  std::vector<std::byte> expected;
  for (int strip = 1; strip <= 10; ++strip) expected.insert(expected.end(), kWidth / 2U, static_cast<std::byte>(strip));
  UnequalStrips own, other;
  FailingStep never;
  SecondCore second(other);
  std::array<std::byte, 3> memory[3];
  const Thread thread(second);
  Sleep clock;
  constexpr std::uint32_t kFrames = 500;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    own.frame = frame;
    const auto begin = [&] {
      other.frame = frame;
      return DrawStatus{};
    };
    second.start(begin);
    LonelyDisplay display(never);
    ASSERT_TRUE(present(own, second, display, kLayout, {memory[0], memory[1], memory[2]}, clock));
    ASSERT_EQ(display.shown, expected) << frame;
  }
  EXPECT_EQ(own.drawn + other.drawn, kFrames * 10);
}

TEST(SecondCore, TheLockHoldsTheOtherCoreOut) {
  constexpr int kTimes = 100;
  TwoCoreLock lock;
  std::atomic<int> ready = 0, inside = 0, together = 0;
  const auto hold_often = [&](Core core) {
    ++ready;
    while (ready < 2) {
    }
    for (int i = 0; i < kTimes; ++i) {
      const TwoCoreHold hold(lock, core);
      together += inside++;
      if (i % 10 == 0) std::this_thread::yield();  // in favour of the other one, where there is one processor
      --inside;
    }
  };
  std::thread other([&] { hold_often(Core::second); });
  hold_often(Core::first);
  other.join();
  EXPECT_EQ(together, 0);
}

}  // namespace
}  // namespace zstrip::hal
