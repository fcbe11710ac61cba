// Benchmark workloads on the MPS2 and MPS3 in the emulator: the pixels are those of the host, on every processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host_render.hpp"
#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

struct Processor {
  const char* name;
  const char* machine;
  char code = '0';  // the first digit of its addresses
};

std::ostream& operator<<(std::ostream& stream, const Processor& processor) { return stream << processor.name; }

/// There is no machine with a Cortex-M0 and this much memory; its code runs on a Cortex-M3 as well.
constexpr Processor kProcessors[] = {{"m0", "mps2-an385"}, {"m3", "mps2-an385"},       {"m4f", "mps2-an386"},
                                     {"m7", "mps2-an500"}, {"m33", "mps2-an505", '1'}, {"m55", "mps3-an547", '1'}};

struct Workload {
  const char* name;
  const char* scene;
  std::uint32_t frames;
};

std::ostream& operator<<(std::ostream& stream, const Workload& workload) { return stream << workload.name; }

constexpr Workload kWorkloads[] = {
    {"K5", "knot", 2}, {"CT", "cube", 2}, {"R50", "random50", 2}, {"R10k", "random10k", 1}};

constexpr std::uint16_t kWidth = 320;
constexpr std::uint16_t kHeight = 240;
constexpr std::uint16_t kBoardRows = 16;
constexpr std::uint32_t kFirstFrame = 7;

Qemu::Finished run(const Processor& processor, const std::string& name, const std::vector<std::string>& words,
                   bool count_instructions = true) {
  Qemu board({.machine = processor.machine,
              .program = program("zstrip_" + name + "_" + processor.name),
              .words = words,
              .count_instructions = count_instructions});
  return board.finish(Qemu::Duration(300'000));
}

Qemu::Finished run_bench(const Processor& processor, const std::vector<std::string>& words) {
  return run(processor, "bench", words);
}

std::string hex(std::uint32_t value) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", value);
  return digits;
}

class Mps2 : public testing::TestWithParam<std::tuple<Processor, Workload>> {};

TEST_P(Mps2, PixelsAreThoseOfTheHost) {
  const auto& [processor, workload] = GetParam();
  const auto [output, status] = run_bench(
      processor, {std::string("workload=") + workload.name, "size=320x240", "rows=" + std::to_string(kBoardRows),
                  "first=" + std::to_string(kFirstFrame), "frames=" + std::to_string(workload.frames)});
  ASSERT_EQ(status, 0) << output;
  const auto result = nlohmann::json::parse(output);
  EXPECT_EQ(result["target"], processor.name);
  EXPECT_EQ(result["workload"], workload.name);
  EXPECT_EQ(result["strip_rows"], kBoardRows);
  ASSERT_EQ(result["frames"].size(), workload.frames);
  for (std::uint32_t index = 0; index < workload.frames; ++index) {
    const std::uint32_t frame = kFirstFrame + index;
    const auto& measured = result["frames"][index];
    EXPECT_EQ(measured["frame"], frame);
    const auto expected = [&](std::uint16_t rows) {
      return hex(workload_crc32(workload.scene, frame, kWidth, kHeight, rows));
    };
    EXPECT_EQ(measured["crc32"], expected(kBoardRows)) << "board and host differ in frame " << frame;
    EXPECT_EQ(measured["crc32"], expected(kHeight)) << "strips and the whole picture differ in frame " << frame;
    // A frame at least writes each of its pixels, two at a time.
    EXPECT_GT(measured["instructions"], kWidth * kHeight / 8);
  }
  RecordProperty("instructions_per_frame", result["instructions_per_frame"].dump());
}

/// Strips that cut many triangles.
TEST_P(Mps2, BinnedPixelsAreThoseOfTheHost) {
  const auto& [processor, workload] = GetParam();
  const auto [output, status] =
      run(processor, "bench_bins",
          {std::string("workload=") + workload.name, "size=320x240", "rows=5", "first=" + std::to_string(kFirstFrame)});
  ASSERT_EQ(status, 0) << output;
  const auto result = nlohmann::json::parse(output);
  EXPECT_EQ(result["mode"], "binned");
  EXPECT_EQ(result["bin_overflows"], 0);
  ASSERT_EQ(result["frames"].size(), 1);
  EXPECT_EQ(result["frames"][0]["crc32"], hex(workload_crc32(workload.scene, kFirstFrame, kWidth, kHeight, 5)));
}

INSTANTIATE_TEST_SUITE_P(Board, Mps2, testing::Combine(testing::ValuesIn(kProcessors), testing::ValuesIn(kWorkloads)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) + "_" + std::get<1>(test.param).name;
                         });

TEST(Board, Mps2CountsTheSameInEveryRun) {
  const std::vector<std::string> words{"workload=CT", "size=64x48", "rows=8"};
  const auto first = run_bench(kProcessors[1], words);
  EXPECT_EQ(first.status, 0) << first.output;
  EXPECT_EQ(first.output, run_bench(kProcessors[1], words).output);
}

TEST(Board, Mps2RefusesWrongWords) {
  for (const char* word : {"workload=K6", "size=320", "size=x", "size=70000x1", "rows=-1", "frames=0", "nonsense"}) {
    const auto [output, status] = run_bench(kProcessors[1], {word});
    EXPECT_EQ(status, 2) << word << ": " << output;
    EXPECT_TRUE(output.starts_with("bench: ")) << output;
  }
}

TEST(Board, Mps2SaysHowMuchMemoryIsMissing) {
  const auto [output, status] = run_bench(kProcessors[1], {"workload=CT", "ram=100"});
  EXPECT_EQ(status, 5) << output;
  EXPECT_NE(output.find("available 100"), std::string::npos) << output;
}

TEST(Board, Mps2RefusesToMeasureWithoutCountedInstructions) {
  Qemu board({.machine = "mps2-an385", .program = program("zstrip_bench_m3"), .words = {"workload=CT"}});
  const auto [output, status] = board.finish();
  EXPECT_EQ(status, 1) << output;
  EXPECT_NE(output.find("icount"), std::string::npos) << output;
}

class Mps2SelfTest : public testing::TestWithParam<Processor> {};
INSTANTIATE_TEST_SUITE_P(Board, Mps2SelfTest, testing::ValuesIn(kProcessors),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Mps2SelfTest, StartUpAndMemoryFunctions) {
  const auto [output, status] = run(GetParam(), "self_test", {"memory"});
  EXPECT_EQ(output, "self-test: memory is right\n");
  EXPECT_EQ(status, 0);
}

std::string fault_in_code(const Processor& processor) { return std::string("fault: exception 3 pc ") + processor.code; }

TEST_P(Mps2SelfTest, FaultsAreReported) {
  const auto [output, status] = run(GetParam(), "self_test", {"fault"});
  EXPECT_TRUE(output.starts_with(fault_in_code(GetParam()))) << output;
  EXPECT_EQ(status, 70);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The contracts of the kernels (tests/kernels): the board names those for which its processor has code of its own,
/// and knows how many cases each must compare. The emulator is faster where it counts no instructions.
TEST_P(Mps2SelfTest, AssemblyIsItsCpp) {
  constexpr std::size_t kLeast = 13;  // all but the spans of vectors
  const auto [names, listed] = run(GetParam(), "self_test", {"kernels"}, false);
  ASSERT_EQ(listed, 0) << names;
  const std::vector<std::string> kernels = lines_of(names);
  EXPECT_GE(kernels.size(), kLeast) << names;
  for (const std::string& kernel : kernels) {
    const auto [output, status] = run(GetParam(), "self_test", {"kernel=" + kernel}, false);
    EXPECT_EQ(status, 0) << output;
    EXPECT_TRUE(output.starts_with("self-test: " + kernel + ": ")) << output;
    EXPECT_TRUE(output.ends_with(" are equal\n")) << output;
  }
}

TEST_P(Mps2SelfTest, FaultsReturnToWhoMarkedAPlace) {
  const auto [output, status] = run(GetParam(), "self_test", {"return"});
  ASSERT_TRUE(output.starts_with(fault_in_code(GetParam()))) << output;
  constexpr std::size_t kWord = sizeof "fault: " - 1;
  const std::string words = output.substr(kWord, sizeof "exception 3 pc 00000000 lr 00000000" - 1);
  EXPECT_EQ(output.substr(output.find('\n') + 1), "self-test: back from " + words + "\n");
  EXPECT_EQ(status, 0);
}

TEST_P(Mps2SelfTest, SecondFaultHalts) {
  const auto [output, status] = run(GetParam(), "self_test", {"twice"});
  ASSERT_TRUE(output.starts_with(fault_in_code(GetParam()))) << output;
  const std::string second = output.substr(output.find('\n') + 1);
  EXPECT_TRUE(second.starts_with("self-test: again\n" + fault_in_code(GetParam()))) << output;
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 3) << output;
  EXPECT_EQ(status, 70);
}

/// The processor had reserved a place for FPU registers in the frame of the fault, and wrote there later.
TEST_P(Mps2SelfTest, FpuRegistersDoNotGoToTheStackOfAFaultThatWasLeft) {
  const auto [output, status] = run(GetParam(), "self_test", {"fpu"});
  const std::string name = GetParam().name;
  const bool has_fpu = name == "m4f" || name == "m7" || name == "m55";
  EXPECT_TRUE(output.ends_with(has_fpu ? "\nself-test: the stack is untouched\n" : "self-test: no FPU\n")) << output;
  EXPECT_EQ(status, 0);
}

TEST_P(Mps2SelfTest, WaitOfOneCycleEnds) {
  const auto [output, status] = run(GetParam(), "self_test", {"wait"});
  EXPECT_EQ(output, "self-test: waited\n");
  EXPECT_EQ(status, 0);
}

/// A bus fault has its address, and says nothing of the other kind's. Code for the Cortex-M0, which has no such
/// registers, names no address.
TEST_P(Mps2SelfTest, FaultsNameTheAddressThatIsValid) {
  const auto [output, status] = run(GetParam(), "self_test", {"fault"});
  const char* const address = GetParam().name == std::string("m0") ? "" : " bfar 3f000000\n";
  EXPECT_EQ(output.substr(std::min(output.find(" bfar"), output.size())), address) << output;
  EXPECT_EQ(output.find("mmfar"), std::string::npos) << output;
}

/// Code for the Cortex-M0, the first, counts neither on a memory protection unit nor on a limit of the stack.
class Mps2StackLimit : public testing::TestWithParam<Processor> {};
INSTANTIATE_TEST_SUITE_P(Board, Mps2StackLimit,
                         testing::ValuesIn(std::next(std::begin(kProcessors)), std::end(kProcessors)),
                         [](const auto& test) { return std::string(test.param.name); });

/// It is noticed before anything is written behind the RAM.
TEST_P(Mps2StackLimit, StackOverflowIsReported) {
  const auto [output, status] = run(GetParam(), "self_test", {"overflow"});
  EXPECT_TRUE(output.starts_with("fault: exception 3 stack overflow")) << output;
  EXPECT_EQ(output.find("bfar"), std::string::npos) << output;
  EXPECT_EQ(status, 70);
}

}  // namespace
}  // namespace zstrip::boards
