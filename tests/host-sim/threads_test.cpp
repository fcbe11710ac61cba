// Threads: the same pixels, reports and failures with any number of them.
#include <atomic>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "render/parallel.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class Threads : public FolderTest {
 protected:
  /// The report without what may differ: times.
  nlohmann::json report(const std::string& threads, std::vector<std::string> options) {
    std::vector<std::string> arguments{"render", "knot_meshlets", "--threads", threads, "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(ZSTRIP_COMMAND, arguments, path(""));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    nlohmann::json json = nlohmann::json::parse(outcome.out, nullptr, false);
    if (outcome.status != 0) return json;
    for (nlohmann::json& frame : json.at("frames")) frame.erase("time_ns");
    return json;
  }
};

TEST_F(Threads, StripsOfOneFrame) {
  for (const char* rows : {"1", "7", "100"}) {
    const std::vector<std::string> options{"-o", "frame.png", "--strip-rows", rows};
    const nlohmann::json alone = report("1", options);
    EXPECT_GT(alone.at("frames").at(0).at("statistics").at("fragments"), 1000);
    for (const char* threads : {"2", "3", "8"}) EXPECT_EQ(report(threads, options), alone) << threads << ' ' << rows;
  }
}

TEST_F(Threads, StripsOfPackedFormats) {
  for (const char* format : {"gray4", "mono", "rgb565_swapped"}) {
    const std::vector<std::string> options{"-o",           "frame.raw", "--format",        format,
                                           "--strip-rows", "5",         "--strip-columns", "64"};
    EXPECT_EQ(report("3", options), report("1", options)) << format;
  }
}

TEST_F(Threads, FramesOfATurn) {
  const std::vector<std::string> options{"-o", "frames", "--frames", "7", "--ram", "20K"};
  const nlohmann::json alone = report("1", options);
  ASSERT_EQ(alone.at("frames").size(), 7U);
  std::set<std::string> pictures;
  for (const auto& frame : alone.at("frames")) pictures.insert(frame.at("crc32").get<std::string>());
  EXPECT_EQ(pictures.size(), 7U) << "the model turns";
  for (const char* threads : {"2", "3", "8"}) EXPECT_EQ(report(threads, options), alone) << threads;
}

TEST_F(Threads, FramesOfAModelFile) {
  const std::string model = file("sphere.obj", sphere_obj(40, 25));
  std::vector<nlohmann::json> frames;
  for (const char* threads : {"1", "3"}) {
    const Outcome outcome =
        run(ZSTRIP_COMMAND,
            {"render", model, "-o", "out", "--frames", "5", "--threads", threads, "--quiet", "--json", "-"}, path(""));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    nlohmann::json json = nlohmann::json::parse(outcome.out);
    for (nlohmann::json& frame : json.at("frames")) frame.erase("time_ns");
    frames.push_back(json.at("frames"));
  }
  EXPECT_EQ(frames[0], frames[1]);
}

TEST_F(Threads, NumbersOutOfRangeAreRefused) {
  for (const char* threads : {"0", "257", "-1", "many"}) {
    const Outcome outcome = run(ZSTRIP_COMMAND, {"render", "cube", "-o", "cube.png", "--threads", threads}, path(""));
    EXPECT_EQ(outcome.status, 2) << threads << outcome.err;
  }
}

TEST(ForEachOnThreads, EveryIndexOnceAndNoThreadTwiceAtATime) {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    std::vector<std::atomic<int>> done(100);
    std::vector<std::atomic<int>> busy(threads);
    const Result<Done> result = for_each_on_threads(100, threads, [&](unsigned thread, std::uint32_t index) {
      EXPECT_EQ(busy.at(thread)++, 0);
      ++done.at(index);
      --busy.at(thread);
      return Result<Done>(Done{});
    });
    EXPECT_TRUE(result);
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
  EXPECT_TRUE(for_each_on_threads(0, 4, [](unsigned, std::uint32_t) {
    ADD_FAILURE() << "there is nothing to do";
    return Result<Done>(Done{});
  }));
}

TEST(ForEachOnThreads, TheFirstFailureIsTheLoops) {
  for (const unsigned threads : {1U, 2U, 8U}) {
    std::atomic<std::uint32_t> begun = 0;
    const Result<Done> result = for_each_on_threads(1000, threads, [&](unsigned, std::uint32_t index) {
      ++begun;
      if (index >= 20) return Result<Done>(Failure{ExitStatus::output, std::to_string(index)});
      return Result<Done>(Done{});
    });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.failure().message, "20");
    EXPECT_LT(begun, 100U) << "nothing is begun after a failure";
    EXPECT_THROW((void)for_each_on_threads(
                     10, threads, [](unsigned, std::uint32_t) -> Result<Done> { throw std::runtime_error("out"); }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
