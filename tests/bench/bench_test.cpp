// zstrip bench: workloads, comparison figures, other programs' output, and the command's results and failures.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench_report.hpp"
#include "bench/board_bench.hpp"
#include "bench/board_visibility.hpp"
#include "bench/child_process.hpp"
#include "bench/elf_size.hpp"
#include "bench/peers.hpp"
#include "bench/workloads.hpp"
#include "own_folder.hpp"

namespace zstrip::sim {
namespace {

using nlohmann::json;
using std::chrono::seconds;

/// Without valgrind no instructions of this machine are counted, which takes longest.
enum class Valgrind { found, hidden };

ChildOutput bench(std::vector<std::string> options, Valgrind valgrind = Valgrind::found) {
  options.insert(options.begin(), {ZSTRIP_COMMAND, "bench"});
  if (valgrind == Valgrind::hidden) options.insert(options.begin(), {"env", "PATH=/nonexistent"});
  const Result<ChildOutput> output = run_program(options, seconds{100});
  EXPECT_TRUE(output) << output.failure().message;
  return output ? *output : ChildOutput{-1, ""};
}

// The rows that a run writes to a file.
json bench_rows(std::vector<std::string> options, Valgrind valgrind = Valgrind::found) {
  const test::OwnFolder folder;
  const std::string file = folder.path() / "rows.json";
  options.insert(options.end(), {"--json", file});
  const ChildOutput output = bench(options, valgrind);
  EXPECT_EQ(output.exit_status, 0) << output.text;
  std::ifstream stream(file);
  return json::parse(stream, nullptr, false);
}

TEST(Workloads, AllNameABuiltInScene) {
  ASSERT_EQ(workloads().size(), 9U);
  for (const Workload& workload : workloads()) EXPECT_NE(workload.built_in(), nullptr) << workload.name;
  EXPECT_EQ(find_workload("knot"), nullptr);
}

TEST(Peers, BestIsTheFewestInstructionsOfTheSameCase) {
  BenchCase bench_case{.workload = "CT", .target = "host", .view = {320, 240}, .budget = {}, .frames = kPeerFrames};
  EXPECT_EQ(best_peer(bench_case).name, "Allegro 4");
  EXPECT_DOUBLE_EQ(best_peer(bench_case).million_instructions, 2.13);
  bench_case.target = "m4f";
  EXPECT_EQ(best_peer(bench_case).name, "tgx");
}

TEST(Peers, NoneForOtherSizesFramesOrTargets) {
  const BenchCase measured{
      .workload = "R50", .target = "host", .view = {1920, 1080}, .budget = {}, .frames = kPeerFrames};
  EXPECT_FALSE(best_peer(measured).name.empty());
  BenchCase other = measured;
  other.view.width = 1280;
  EXPECT_TRUE(best_peer(other).name.empty());
  other = measured;
  other.frames = 1;
  EXPECT_TRUE(best_peer(other).name.empty());
  other = measured;
  other.target = "m7";
  EXPECT_TRUE(best_peer(other).name.empty());
}

TEST(ChildProcess, KeepsBothStreamsAndTheStatus) {
  const Result<ChildOutput> output = run_program({"sh", "-c", "echo one; echo two >&2; exit 7"}, seconds{10});
  ASSERT_TRUE(output);
  EXPECT_EQ(output->exit_status, 7);
  EXPECT_EQ(output->text, "one\ntwo\n");
}

TEST(ChildProcess, MissingProgramIsAFailure) {
  const Result<ChildOutput> output = run_program({"no-such-program-of-zstrip"}, seconds{10});
  ASSERT_FALSE(output);
  EXPECT_EQ(output.failure().status, ExitStatus::environment);
}

TEST(ChildProcess, IsEndedWhenTheTimeIsUp) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<ChildOutput> output = run_program({"sleep", "30"}, seconds{1});
  ASSERT_FALSE(output);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds{20});
}

TEST(ChildProcess, IsEndedIfItClosesItsOutputAndGoesOn) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(run_program({"sh", "-c", "exec >/dev/null 2>&1 sleep 30"}, seconds{1}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds{20});
}

TEST(ChildProcess, MuchOutputIsCutOff) {
  const Result<ChildOutput> output = run_program({"head", "-c", "100000000", "/dev/zero"}, seconds{60});
  ASSERT_TRUE(output);
  EXPECT_EQ(output->exit_status, 0);
  EXPECT_GT(output->text.size(), 60'000'000U);
  EXPECT_LT(output->text.size(), 70'000'000U);
}

TEST(ElfSize, RefusesWhatIsNoProgram) {
  const test::OwnFolder folder;
  const std::filesystem::path file = folder.path() / "not_an_elf";
  std::ofstream(file) << "\x7f"
                         "ELF\x01 cut short";
  EXPECT_FALSE(elf_load_bytes(file));
  std::filesystem::remove(file);
  EXPECT_FALSE(elf_load_bytes(file));
}

TEST(BenchReport, AbsentFiguresAreNull) {
  const Measurement row{.bench_case = {.workload = "K5", .target = "m3", .view = {32, 24}, .budget = {}, .frames = 1},
                        .frame_crc32 = {0x0000ABCD}};
  const json object = json::parse(bench_json({&row, 1})).at(0);
  EXPECT_TRUE(object.at("ns_per_frame").is_null());
  EXPECT_TRUE(object.at("instructions_per_frame").is_null());
  EXPECT_EQ(object.at("frame_crc32"), json::array({"0000abcd"}));
}

// Regression: programs of the visibility methods were asked for the workload "scene", which only those of files have.
TEST(BoardBench, WordsOfAProgramNameItsWorkload) {
  const std::vector<BenchCase> cases = board_visibility_cases();
  EXPECT_EQ(cases.size(), 40U);
  for (const BenchCase& bench_case : cases) {
    EXPECT_EQ(board_words(bench_case).rfind(",arg=workload=" + bench_case.workload + ",", 0), 0U);
    EXPECT_NE(board_words(bench_case).find(",arg=depth=" + bench_case.depth), std::string::npos);
  }
  BenchCase file;
  file.workload = "my model.glb";
  file.scene_file = "a.zsc";
  file.program = "zstrip_played_m0";
  EXPECT_EQ(board_words(file).rfind(",arg=workload=scene,", 0), 0U);
  file.program.clear();
  EXPECT_EQ(board_words(file).rfind(",arg=workload=my model.glb,", 0), 0U);
}

TEST(BenchCommand, MeasuresEveryWorkload) {
  const json rows = bench_rows({"--size", "64x48", "--frames", "2"}, Valgrind::hidden);
  ASSERT_EQ(rows.size(), 4U);
  for (const json& row : rows) {
    EXPECT_GT(row.at("ns_per_frame").get<double>(), 0);
    EXPECT_GT(row.at("ram_bytes").get<int>(), 64 * 48 * 2);
    EXPECT_EQ(row.at("config").at("width"), 64);
    ASSERT_EQ(row.at("frame_crc32").size(), 2U);
    EXPECT_NE(row.at("frame_crc32")[0], row.at("frame_crc32")[1]) << "the model turns";
  }
}

TEST(BenchCommand, CountsTheSameInstructionsTwice) {
  const std::vector<std::string> options{"--workload", "K5", "--size", "64x48", "--frames", "2"};
  const json first = bench_rows(options);
  if (first.at(0).at("instructions_per_frame").is_null())
    GTEST_SKIP() << "valgrind is missing, or this is a sanitized build";
  const json second = bench_rows(options);
  const auto count = first.at(0).at("instructions_per_frame").get<std::uint64_t>();
  EXPECT_GT(count, 10'000U);
  EXPECT_EQ(second.at(0).at("instructions_per_frame").get<std::uint64_t>(), count);
}

TEST(BenchCommand, StripRowsChangeMemoryButNoPixel) {
  const std::vector<std::string> options{"--workload", "CT", "--size", "61x47", "--frames", "2"};
  const json whole = bench_rows(options, Valgrind::hidden);
  std::vector<std::string> in_strips = options;
  in_strips.insert(in_strips.end(), {"--strip-rows", "7"});
  const json strips = bench_rows(in_strips, Valgrind::hidden);
  EXPECT_EQ(whole.at(0).at("frame_crc32"), strips.at(0).at("frame_crc32"));
  EXPECT_LT(strips.at(0).at("ram_bytes").get<int>(), whole.at(0).at("ram_bytes").get<int>());
}

/// The model of a package goes to boards as a baked scene.
TEST(BenchCommand, DrawsModelsOfPackages) {
  ASSERT_GE(model_workloads().size(), 1U);
  for (const Workload& workload : model_workloads()) {
    std::vector<std::string> options{"--workload", std::string(workload.name), "--size", "64x48", "--frames", "2"};
    if (workload.built_in() == nullptr) {
      const ChildOutput output = bench(options);
      EXPECT_EQ(output.exit_status, 3) << output.text;
      GTEST_SKIP() << output.text;
    }
    if (!run_program({"qemu-system-arm", "--version"}, seconds{30}) ||
        !std::filesystem::exists(std::filesystem::path(ZSTRIP_FIRMWARE_BINARIES) / "zstrip_bench_scene_m3.elf")) {
      GTEST_SKIP() << "no emulator, or no programs for it";
    }
    const json host = bench_rows(options, Valgrind::hidden);
    options.insert(options.end(), {"--target", "m3", "--firmware", ZSTRIP_FIRMWARE_BINARIES});
    const json board = bench_rows(options);
    ASSERT_EQ(host.size(), 1U);
    ASSERT_EQ(board.size(), 1U);
    EXPECT_EQ(host.at(0).at("frame_crc32"), board.at(0).at("frame_crc32"));
    EXPECT_NE(host.at(0).at("frame_crc32")[0], host.at(0).at("frame_crc32")[1]) << "the model turns";
    EXPECT_GT(board.at(0).at("instructions_per_frame").get<std::uint64_t>(), 1'000'000U);
    EXPECT_EQ(bench({"--workload", std::string(workload.name), "--target", "m3", "--mode", "binned"}).exit_status, 2);
  }
}

TEST(BenchCommand, TooLittleMemorySaysHowMuchIsNeeded) {
  const ChildOutput output = bench({"--workload", "K5", "--ram", "64", "--frames", "1"});
  EXPECT_EQ(output.exit_status, 5);
  EXPECT_NE(output.text.find("bytes"), std::string::npos) << output.text;
}

TEST(BenchCommand, HelpNamesTheValues) {
  const std::string help = bench({"--help"}).text;
  for (const char* value : {"--size WxH", "--strip-rows N|auto", "--ram BYTES", "--json FILE|-", "--firmware DIR"}) {
    EXPECT_NE(help.find(value), std::string::npos) << value;
  }
}

/// All programs of three processors were built for one of them.
TEST(BenchCommand, NamesTheProgramsThatItRuns) {
  const auto listed = [](std::vector<std::string> options) {
    options.emplace_back("--list-programs");
    const ChildOutput output = bench(options);
    EXPECT_EQ(output.exit_status, 0) << output.text;
    return output.text;
  };
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"--target", "M3", "--workload", "K5,CT"}), "zstrip_bench_m3\n");
  EXPECT_EQ(listed({"--target", "host,rv32,m4f"}), "zstrip_bench_m4f\nzstrip_bench_rv32\n");
  EXPECT_EQ(listed({"--target", "m0", "--mode", "binned"}), "zstrip_bench_bins_m0\n");
  EXPECT_EQ(listed({"--target", "m0", "--workload", "R50", "--depth", "z24"}), "zstrip_bench_depth_m0\n");
  EXPECT_EQ(listed({"--board", "pico,bluepill"}), "zstrip_bench_m0\nzstrip_bench_m3\n");
  EXPECT_EQ(listed({"--table", "boards"}), "zstrip_bench_visibility_m0\nzstrip_bench_visibility_m3\n");
  EXPECT_EQ(listed({"--table", "thesis"}) + listed({"--peers"}), "");
}

TEST(BenchCommand, DrawsAreBounded) {
  EXPECT_EQ(bench({"--workload", "CT", "--size", "8x8", "--frames", "1", "--draw-each", "1"}).exit_status, 0);
  EXPECT_EQ(bench({"--workload", "CT", "--size", "8x8", "--frames", "1", "--draw-each", "4000000000"}).exit_status, 2);
}

TEST(BenchCommand, FailuresHaveTheirStatus) {
  EXPECT_EQ(bench({"--workload", "K6"}).exit_status, 2);
  EXPECT_EQ(bench({"--target", "z80"}).exit_status, 2);
  EXPECT_EQ(bench({"--size", "0x0"}).exit_status, 2);
  EXPECT_EQ(bench({"--frames", "0"}).exit_status, 2);
  EXPECT_EQ(bench({"--workload", "K5", "--strip-rows", "4000"}).exit_status, 2);
  EXPECT_EQ(bench({"--target", "m3", "--firmware", "/nonexistent"}).exit_status, 3);
  EXPECT_EQ(
      bench({"--workload", "CT", "--size", "8x8", "--frames", "1", "--json", "/nonexistent/rows.json"}).exit_status, 6);
}

}  // namespace
}  // namespace zstrip::sim
