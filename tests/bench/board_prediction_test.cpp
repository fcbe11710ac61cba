// zstrip bench --board: classes of instructions, cycles, the flash's cache, the timeline, and the command.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "bench/board_model.hpp"
#include "bench/child_process.hpp"
#include "bench/cycle_model.hpp"
#include "bench/execution_profile.hpp"
#include "bench/instruction_class.hpp"
#include "bench/plugin/flash_cache.hpp"
#include "bench/strip_timeline.hpp"
#include "own_folder.hpp"

namespace zstrip::sim {
namespace {

using nlohmann::json;

TEST(InstructionClass, MnemonicsOfThumb) {
  using enum InstructionClass;
  const std::pair<std::string_view, InstructionClass> kExpected[] = {{"add.w r3, r3, #1", other},
                                                                     {"mls r1, r2, r3, r4", accumulate},
                                                                     {"muls r0, r1, r0", multiply},
                                                                     {"smulbb r1, r2, r3", multiply},
                                                                     {"umull r1, r2, r3, r4", long_multiply},
                                                                     {"umlal r1, r2, r3, r4", long_accumulate},
                                                                     {"udiv r1, r2, r3", divide},
                                                                     {"ldrsh.w r0, [r1]", load},
                                                                     {"strb r0, [r1, #4]", store},
                                                                     {"ldrd r0, r1, [sp]", load_multiple},
                                                                     {"push {r4, r5, lr}", store_multiple},
                                                                     {"bls #0x10", branch},
                                                                     {"blt.w #0x10", branch},
                                                                     {"b #0x10", branch},
                                                                     {"cbnz r0, #0x10", branch},
                                                                     {"bl #0x10", call},
                                                                     {"bx lr", branch_register},
                                                                     {"blx r3", branch_register},
                                                                     {"bic r0, r1, #3", other},
                                                                     {"bfi r0, r1, #3, #4", other},
                                                                     {"it eq", other}};
  for (const auto& [text, kind] : kExpected) EXPECT_EQ(classify(text).kind, kind) << text;
  EXPECT_EQ(classify("push {r4, r5, lr}").words, 3U);
  EXPECT_EQ(classify("ldrd r0, r1, [sp]").words, 2U);
  EXPECT_TRUE(classify("pop {r4, pc}").loads_pc);
  EXPECT_FALSE(classify("pop {r4, r5}").loads_pc);
  EXPECT_TRUE(classify("ldr.w pc, [sp], #4").loads_pc);
  for (const std::string_view text : {"add.w r0, r1, r2, lsr #4", "ands.w r0, r1, r2, lsl #4", "sub.w r0, r1, #0x1000",
                                      "cmp.w r0, r1, asr #31", "bic r0, r1, #256"}) {
    EXPECT_TRUE(classify(text).complex) << text;
  }
  for (const std::string_view text :
       {"add.w r0, r1, r2, lsl #3", "movw r0, #0x1234", "mov.w r0, #0x1000", "lsrs r0, r1, #4", "addw r0, r1, #0x234",
        "ubfx r0, r1, #4, #8", "cmp r0, #255"}) {
    EXPECT_FALSE(classify(text).complex) << text;
  }
}

TEST(FlashCache, KeepsTheLinesUsedLast) {
  FlashCache cache(4, 2, 8);  // two sets of two
  EXPECT_EQ(cache.line_of(17), 2U);
  EXPECT_FALSE(cache.touch(0));
  EXPECT_FALSE(cache.touch(2));
  EXPECT_TRUE(cache.touch(0));
  EXPECT_FALSE(cache.touch(4));  // in the place of 2, used longest ago
  EXPECT_TRUE(cache.touch(0));
  EXPECT_FALSE(cache.touch(2));
  EXPECT_FALSE(cache.touch(1));  // the other set
  EXPECT_TRUE(cache.touch(2));
  FlashCache none(0, 1, 8);
  EXPECT_FALSE(none.touch(1));
  EXPECT_FALSE(none.touch(1));
}

// A loop of ldr, adds, bne that runs five times, one of them to its end.
ExecutionProfile loop_profile() {
  return {.instructions = {{0, 2, "ldr r0, [r1]"}, {2, 2, "adds r0, r0, #1"}, {4, 2, "bne #0x0"}},
          .blocks = {{0, 3}},
          .regions = {{.blocks = {{0, 5, 4}}, .jump_misses = 4, .sequential_misses = 3, .data_misses = 2}}};
}

TEST(CycleModel, SumsThePublishedTimings) {
  const ExecutionProfile profile = loop_profile();
  const ExecutedRegion& region = profile.regions[0];
  EXPECT_EQ(instruction_count(profile, region), 15U);
  const Cycles m0 = core_cycles(profile, region, *find_core("m0"));  // 5 * (2 + 1 + 1), 4 * 2 for branches taken
  EXPECT_DOUBLE_EQ(m0.low, 28);
  EXPECT_DOUBLE_EQ(m0.high, 28);
  const Cycles m3 = core_cycles(profile, region, *find_core("m3"));  // 1 to 3 cycles refill the pipeline
  EXPECT_DOUBLE_EQ(m3.low, 24);
  EXPECT_DOUBLE_EQ(m3.high, 32);
  const InstructionMix mix = mix_of(profile, region);
  EXPECT_EQ(mix.count[static_cast<std::size_t>(InstructionClass::load)], 5U);
  EXPECT_EQ(mix.count[static_cast<std::size_t>(InstructionClass::branch)], 5U);
  EXPECT_EQ(mix.taken, 4U);
}

TEST(CycleModel, FlashWaits) {
  const ExecutionProfile profile = loop_profile();
  const ExecutedRegion& region = profile.regions[0];
  Flash flash{.description{}, .wait_states = 2, .cache = {.line_bytes = 8}, .prefetch = false};
  EXPECT_DOUBLE_EQ(flash_cycles(region, flash).low, 2 * (4 + 3 + 2));
  EXPECT_DOUBLE_EQ(flash_cycles(region, flash).high, 2 * (4 + 3 + 2));
  flash.prefetch = true;  // of the lines in sequence it hides two of three cycles at least
  EXPECT_DOUBLE_EQ(flash_cycles(region, flash).low, 2 * (4 + 2));
  EXPECT_DOUBLE_EQ(flash_cycles(region, flash).high, 2 * (4 + 2) + 3);
}

TEST(CycleModel, EveryBoardHasATimedCoreAndAProgramOrARange) {
  const std::size_t timed = boards_with_core_model().size();
  EXPECT_EQ(timed, 5U);
  for (const BoardModel& board : board_models().subspan(timed)) {
    EXPECT_TRUE(board.core.empty() && board.target.empty()) << board.name;
    EXPECT_LT(board.cycles_per_estimate.low, board.cycles_per_estimate.high) << board.name;
    EXPECT_GT(board.ram_bytes, kReservedRam) << board.name;
  }
  for (const BoardModel& board : boards_with_core_model()) {
    EXPECT_NE(find_core(board.core), nullptr) << board.name;
    EXPECT_TRUE(board.target == "m0" || board.target == "m3" || board.target == "m4f" || board.target == "m33")
        << board.name;
    EXPECT_GT(board.ram_bytes, kReservedRam) << board.name;
  }
}

TEST(StripTimeline, OneBufferTakesTurnsTwoOverlap) {
  const std::vector<StripWork> strips{{3, 5}, {4, 5}, {9, 5}};
  const auto in_turns = strip_timeline(1, strips, false);
  EXPECT_DOUBLE_EQ(in_turns.back().send_end, 1 + 3 + 5 + 4 + 5 + 9 + 5);
  const auto overlapped = strip_timeline(1, strips, true);
  EXPECT_DOUBLE_EQ(overlapped[0].send_begin, 4);
  EXPECT_DOUBLE_EQ(overlapped[1].draw_begin, 4);
  EXPECT_DOUBLE_EQ(overlapped[1].send_begin, 9);  // the bus is busy until then
  EXPECT_DOUBLE_EQ(overlapped[2].draw_begin, 9);  // and so is the other buffer
  EXPECT_DOUBLE_EQ(overlapped[2].send_end, 9 + 9 + 5);
}

TEST(StripTimeline, TwoCoresTakeStripsWhenTheyAreFree) {
  const std::vector<StripWork> strips{{3, 5}, {4, 5}, {9, 5}};
  const auto times = two_core_timeline(1, strips);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[0].draw_begin, 1);
  EXPECT_DOUBLE_EQ(times[1].draw_begin, 1);
  EXPECT_DOUBLE_EQ(times[0].send_begin, 4);
  EXPECT_DOUBLE_EQ(times[2].draw_begin, 4);  // by the first core; the second one waits for the bus
  EXPECT_DOUBLE_EQ(times[1].send_begin, 9);
  EXPECT_DOUBLE_EQ(times[2].send_begin, 14);
  EXPECT_DOUBLE_EQ(times[2].send_end, 19);
  // Where the bus is quick a frame takes half as long.
  const std::vector<StripWork> slow(8, {10, 1});
  EXPECT_DOUBLE_EQ(two_core_timeline(0, slow).back().send_end, 4 * 10 + 2);
}

TEST(StripTimeline, TwoCoresShareStripsOfUnequalWork) {
  // While one draws the second strip, the other one draws two; of three buffers none is free for a fifth.
  const std::vector<StripWork> strips{{1, 1}, {20, 1}, {8, 1}, {8, 1}, {5, 1}};
  const auto times = two_core_timeline(0, strips);
  EXPECT_DOUBLE_EQ(times[2].draw_begin, 1);
  EXPECT_DOUBLE_EQ(times[3].draw_begin, 9);
  EXPECT_DOUBLE_EQ(times[1].send_begin, 20);
  EXPECT_DOUBLE_EQ(times[2].send_begin, 21);
  EXPECT_DOUBLE_EQ(times[4].draw_begin, 21);
  EXPECT_DOUBLE_EQ(times[3].send_begin, 22);
  EXPECT_DOUBLE_EQ(times[4].send_begin, 26);
  // A bus that is slower than two cores is never idle.
  const std::vector<StripWork> bound(10, {10, 9});
  EXPECT_DOUBLE_EQ(two_core_timeline(0, bound).back().send_end, 10 + 10 * 9);
}

TEST(ExecutionProfile, RefusesWhatThePluginDoesNotWrite) {
  const test::OwnFolder folder;
  const std::filesystem::path file = folder.path() / "profile.txt";
  const auto read = [&file](const char* text) {
    std::ofstream(file) << text;
    return static_cast<bool>(read_profile(file));
  };
  const std::string good = "i 10 2 nop\nb 0 10 1\nx 0 7 1\nr 1 2 3 4\n";
  EXPECT_TRUE(read(good.c_str()));
  EXPECT_FALSE(read(""));
  EXPECT_FALSE(read("i 10 2 nop\nb 0 10 1\nx 0 7 1\n"));  // cut short
  EXPECT_FALSE(read("b 0 10 1\nx 0 7 1\nr 1 2 3 4\n"));   // an instruction that was not described
  EXPECT_FALSE(read("i 10 2 nop\nb 0 10 1\nx 1 7 1\nr 1 2 3 4\n"));
  EXPECT_FALSE(read("i 10 2\nr 1 2 3 4\n"));
  EXPECT_FALSE(read("hello\n"));
}

ChildOutput bench(std::vector<std::string> options) {
  options.insert(options.begin(), {ZSTRIP_COMMAND, "bench"});
  const Result<ChildOutput> output = run_program(options, std::chrono::seconds{110});
  EXPECT_TRUE(output) << output.failure().message;
  return output ? *output : ChildOutput{-1, ""};
}

class BoardCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / "zstrip_bench_m3.elf") ||
        !run_program({"qemu-system-arm", "--version"}, std::chrono::seconds{30})) {
      GTEST_SKIP() << "no programs for boards, or no QEMU";
    }
  }
  json rows(std::vector<std::string> options) {
    const test::OwnFolder folder;
    const std::string file = folder.path() / "rows.json";
    options.insert(options.end(), {"--firmware", ZSTRIP_FIRMWARE_BINARIES, "--json", file});
    const ChildOutput output = bench(options);
    EXPECT_EQ(output.exit_status, 0) << output.text;
    std::ifstream stream(file);
    return json::parse(stream, nullptr, false);
  }
};

TEST_F(BoardCommand, CountsWhatTheTimerCounts) {
  const std::vector<std::string> same{"--workload", "K5M", "--frames", "2", "--size", "320x240", "--strip-rows", "7"};
  std::vector<std::string> predicted = same, timed = same;
  predicted.insert(predicted.end(), {"--board", "bluepill"});
  timed.insert(timed.end(), {"--target", "m3"});
  const auto count = [](const json& row) { return row.at(0).at("instructions_per_frame").get<double>(); };
  const double plugin = count(rows(predicted)), timer = count(rows(timed));
  EXPECT_NEAR(plugin / timer, 1, 0.002) << plugin << ' ' << timer;
}

/// Of a Cortex-M33: there small triangles of bins are set up once for two strips, where one core draws both.
TEST_F(BoardCommand, TwoCoresHandNothingOnFromStripToStrip) {
  if (!std::filesystem::exists(std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / "zstrip_bench_bins_m33.elf")) {
    GTEST_SKIP() << "no program for a Cortex-M33";
  }
  const auto predicted = [this](const char* mode, const char* cores) {
    return rows({"--board", "pico2", "--workload", "K5", "--frames", "1", "--strip-rows", "8", "--mode", mode,
                 "--cores", cores})
        .at(0);
  };
  const auto count = [](const json& row) { return row.at("instructions_per_frame").get<double>(); };
  const json one = predicted("binned", "1"), two = predicted("binned", "2");
  EXPECT_GT(count(two), 1.05 * count(one));
  EXPECT_LT(count(two), 1.2 * count(one));
  EXPECT_EQ(count(predicted("streamed", "1")), count(predicted("streamed", "2")));
  // Of each strip its own cycles.
  const auto drawing = [](const json& row, std::size_t strip) {
    const json times = row.at("first_frame_slowest").at(strip).at("draw_ms");
    return times.at(1).get<double>() - times.at(0).get<double>();
  };
  const std::size_t strips = one.at("config").at("strips");
  ASSERT_EQ(strips, 30U);
  int judged = 0;
  for (std::size_t strip = 0; strip < strips; ++strip) {
    if (drawing(one, strip) < 0.6) continue;
    EXPECT_NEAR(drawing(two, strip) / drawing(one, strip), 1.12, 0.12) << strip;
    ++judged;
  }
  EXPECT_GT(judged, 8);
}

TEST_F(BoardCommand, PredictsWithinItsAssumptions) {
  const json row = rows({"--board", "bluepill", "--workload", "CT", "--frames", "1"}).at(0);
  EXPECT_LE(row.at("ram_bytes"), 20 * 1024);
  const json fps = row.at("frames_per_second");
  EXPECT_GT(fps.at(0), 0);
  EXPECT_LE(fps.at(0), fps.at(1));
  const json strips = row.at("first_frame_slowest");
  ASSERT_EQ(strips.size(), row.at("config").at("strips"));
  for (std::size_t i = 1; i < strips.size(); ++i) {
    EXPECT_GE(strips[i].at("draw_ms").at(0), strips[i - 1].at("draw_ms").at(1)) << "the core does one thing at a time";
    EXPECT_GE(strips[i].at("send_ms").at(0), strips[i - 1].at("send_ms").at(1)) << "so does the bus";
    EXPECT_GE(strips[i].at("send_ms").at(0), strips[i].at("draw_ms").at(1)) << "what is sent has been drawn";
  }
  // A bus of a tenth is what limits then: 153600 bytes at 1.8 MHz are 683 ms.
  const json slow = rows({"--board", "bluepill", "--workload", "CT", "--frames", "1", "--spi-mhz", "1.8"}).at(0);
  EXPECT_LT(slow.at("frames_per_second").at(1), 1.0 / 0.683);
}

TEST(BoardCommandFailures, HaveTheirStatus) {
  EXPECT_EQ(bench({"--board", "nosuchboard"}).exit_status, 2);
  EXPECT_EQ(bench({"--board", "pico", "--target", "m3"}).exit_status, 2);
  EXPECT_EQ(bench({"--spi-mhz", "1"}).exit_status, 2);
  EXPECT_EQ(bench({"--board", "pico", "--firmware", "/nonexistent"}).exit_status, 3);
  EXPECT_EQ(bench({"--stages", "--target", "host"}).exit_status, 2);
}

/// What the command says, a regular expression, of options that do not go; N is a number.
void expect_refused(const std::vector<std::string>& options, int status, const std::string& words) {
  std::vector<std::string> all = options;
  all.insert(all.end(), {"--frames", "1", "--firmware", ZSTRIP_FIRMWARE_BINARIES});
  const ChildOutput output = bench(all);
  EXPECT_EQ(output.exit_status, status) << output.text;
  const std::regex expected("zstrip: " + std::regex_replace(words, std::regex("\\bN\\b"), "[1-9][0-9,]*") + "\n");
  EXPECT_TRUE(std::regex_match(output.text, expected)) << output.text;
}

TEST_F(BoardCommand, TooLittleRamIsSaid) {
  // 2560 vertices in one piece
  expect_refused({"--board", "microbit", "--workload", "K5"}, 5,
                 "K5 needs N bytes of RAM on m0 for arena and pixels, and has 12,288: microbit has 16,384, of which "
                 "4,096 are for other variables and the stack");
  expect_refused({"--board", "pico", "--cores", "2", "--workload", "R10k", "--size", "320x240"}, 5,
                 "R10k needs N bytes of RAM on m0 for arena and pixels, and has 133,120: pico has 270,336, of which "
                 "4,096 are for other variables and the stack, and each of two cores has half of the others");
  expect_refused({"--board", "pico", "--workload", "K5", "--ram", "12K"}, 5,
                 "K5 needs N bytes of RAM on m0 for arena and pixels, and has 12,288: --ram allows no more");
  expect_refused({"--target", "m0", "--workload", "K5", "--ram", "12K"}, 5,
                 "K5 needs N bytes of RAM on m0 for arena and pixels, and has 12,288");
}

TEST(BoardCommandFailures, NameTheBoardsThatDrawAModel) {
  expect_refused({"--board", "pico2", "--workload", "bunny"}, 2,
                 "bunny is for --board microbit, pico, bluepill, blackpill; pico2 has no program for it");
  expect_refused({"--target", "m33", "--workload", "bunny"}, 2,
                 "bunny is for --target host, m0, m3, m4f and m7; m33 has no program for it");
  expect_refused({"--board", "pico", "--workload", "bunny", "--mode", "binned"}, 2,
                 "bunny is drawn streamed on boards; leave out --mode binned");
  expect_refused({"--target", "rv32", "--workload", "K5", "--mode", "binned"}, 2,
                 "rv32 has no program but for --mode streamed and --depth z16");
}

TEST_F(BoardCommand, WorkloadsOfAProgramAreNamed) {
  expect_refused(
      {"--target", "m3", "--workload", "character", "--mode", "binned"}, 2,
      "the program for m3 that draws binned has no character; it has K5, K5M, CT, K5T, R50, R10k, teapot, room");
}

}  // namespace
}  // namespace zstrip::sim
