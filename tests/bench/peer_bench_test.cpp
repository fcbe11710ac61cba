// zstrip bench --peers: the same pictures by other renderers, where they are installed.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/drawing.hpp"
#include "bench/peer_bench.hpp"
#include "bench/workloads.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

ChildOutput run(std::vector<std::string> command) {
  const Result<ChildOutput> output = run_program(command, std::chrono::seconds{110});
  EXPECT_TRUE(output) << output.failure().message;
  return output ? *output : ChildOutput{-1, ""};
}

/// That are not black, which is the background, in frame 0.
double pixels_of_zstrip(const char* workload) {
  Result<Drawing> drawing = Drawing::prepare(
      {.workload = workload, .target = "host", .view = {320, 240}, .budget = {.modes = Modes::streamed}, .frames = 1});
  EXPECT_TRUE(drawing);
  drawing->stage(0);
  std::vector<std::byte> picture;
  EXPECT_TRUE(drawing->draw([&](std::span<const std::byte> pixels) { picture.assign(pixels.begin(), pixels.end()); }));
  double count = 0;
  for (std::size_t i = 0; i + 1 < picture.size(); i += 2) {
    if (picture[i] != std::byte{0} || picture[i + 1] != std::byte{0}) ++count;
  }
  return count;
}

class Peer : public testing::TestWithParam<const char*> {};

TEST_P(Peer, CoversThePixelsThatZstripCovers) {
  const fs::path program = fs::path(ZSTRIP_COMMAND).parent_path() / GetParam();
  if (!fs::exists(program)) GTEST_SKIP() << program << " was not built: its package is missing";
  for (const char* workload : {"K5", "CT"}) {
    const auto line =
        nlohmann::json::parse(run({program.string(), find_workload(workload)->scene.data(), "320", "240", "1"}).text);
    const double ours = pixels_of_zstrip(workload);
    EXPECT_NEAR(line.at("covered").get<double>(), ours, ours / 50) << workload;
    EXPECT_GT(line.at("ns_per_frame"), 0);
  }
  EXPECT_NE(run({program.string(), "teapot", "320", "240", "1"}).exit_status, 0) << "lit scenes are not theirs";
  EXPECT_EQ(run({program.string(), "cube", "0", "240", "1"}).exit_status, 2);
}

INSTANTIATE_TEST_SUITE_P(Programs, Peer, testing::Values("zstrip_peer_allegro", "zstrip_peer_osmesa"));

TEST(PeerTable, RatiosAreToZstrip) {
  const PeerComparison comparison{
      .rows =
          {{.workload = "CT", .renderer = "zstrip", .nanoseconds_per_frame = 2e6, .instructions_per_frame = 1'000'000},
           {.workload = "CT", .renderer = "other", .nanoseconds_per_frame = 3e6, .instructions_per_frame = 4'000'000},
           {.workload = "CT", .renderer = "uncounted", .nanoseconds_per_frame = 1e6}},
      .skipped = {"third is skipped"}};
  const std::string text = peer_table(comparison);
  EXPECT_NE(text.find("4.000 M    4.00     3.000 ms    1.50"), std::string::npos) << text;
  EXPECT_NE(text.find("third is skipped"), std::string::npos);
  const auto rows = nlohmann::json::parse(peer_json(comparison));
  EXPECT_TRUE(rows.at(2).at("instructions_per_frame").is_null());
}

}  // namespace
}  // namespace zstrip::sim
