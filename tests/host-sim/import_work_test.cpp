// An import says what it does, and ends in time.
#include "import_fixture.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "import/crash_guard.hpp"
#include "text/step_report.hpp"

namespace zstrip::sim::test {
namespace {

/// A model of 4.5 million triangles gave no sign of life for 91 s.
TEST_F(Import, TellsWhatItIsDoing) {
  file("cube.obj", cube_obj());
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{0});
    model(path("cube.obj"));
  }
  model(path("cube.obj"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "zstrip: reading 'cube.obj', 0 s\nzstrip: finding the surfaces of 'cube.obj', 0 s\n"
            "zstrip: merging the vertices of 'cube.obj', 0 s\nzstrip: quantising the vertices, 0 s\n"
            "zstrip: cutting the model into meshlets, 0 s\n");
}

/// The thread that reports must not need the one that works.
TEST(StepReport, TellsAStepThatTakesLong) {
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{20});
    tell_step("waiting");
    std::this_thread::sleep_for(std::chrono::seconds{1});
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("zstrip: waiting, "), std::string::npos);
  testing::internal::CaptureStderr();
  {
    const StepReport report(false, std::chrono::milliseconds{0});
    tell_step("waiting");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

using CrashGuardDeathTest = Import;

TEST_F(CrashGuardDeathTest, EndsALoopAfterItsTime) {
  const auto loop = [] {
    const CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, ~std::uint64_t{0});
    while (std::clock() >= 0) {
    }
  };
  EXPECT_EXIT(loop(), ::testing::ExitedWithCode(4), "^took too long\n$");
}

TEST_F(CrashGuardDeathTest, LiftedLimitsLetWorkGoOn) {
  const auto work = [] {
    CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, 1);
    guard.lift_limits();
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < 2 * CLOCKS_PER_SEC) {
    }
    const std::vector<char> memory(std::size_t{64} << 20);
    std::_Exit(memory.back());
  };
  EXPECT_EXIT(work(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace zstrip::sim::test
