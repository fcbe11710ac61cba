// Instructions that are estimated from what a frame does, against those that an emulated Cortex-M3 counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "bench/workloads.hpp"
#include "render/render_frame.hpp"

namespace zstrip::sim {
namespace {

/// A line of docs/measured/instructions.csv.
struct Row {
  std::string name, workload, target, size, mode, rows, depth;
  std::uint32_t frames = 0;
  double counted = 0;
};

std::vector<Row> rows() {
  std::vector<Row> all;
  std::ifstream file(ZSTRIP_INSTRUCTIONS);
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, ',', ' ');
    Row row;
    if (std::istringstream(line) >> row.name >> row.workload >> row.target >> row.size >> row.mode >> row.rows >>
        row.depth >> row.frames >> row.counted) {
      all.push_back(row);
    }
  }
  return all;
}

/// The mean of the same frames.
double estimated(const Row& row) {
  const scenes::BuiltIn& built_in = *find_workload(row.workload)->built_in();
  View view;
  EXPECT_EQ(std::sscanf(row.size.c_str(), "%hux%hu", &view.width, &view.height), 2);
  Budget budget;
  budget.modes = row.mode == "binned" ? Modes::binned : Modes::streamed;
  if (row.rows != "auto") budget.strip_rows = static_cast<std::uint16_t>(std::stoi(row.rows));
  FrameRenderer renderer(view, budget);
  double sum = 0;
  for (std::uint32_t frame = 0; frame < row.frames; ++frame) {
    scenes::Staged staged;
    scenes::stage_workload(built_in, staged, frame);
    if (built_in.pose != nullptr) {
      EXPECT_TRUE(built_in.pose(frame));
    }
    const Effects effects = effects_of(staged.scene, staged.camera);
    const SceneCounts counts = count(staged.scene);
    const PlanResult planned = plan(counts, view, effects | effect::bins, budget);
    EXPECT_TRUE(planned.status);
    const Result<FrameReport> report = renderer.render({.scene = staged.scene, .camera = staged.camera}, planned.plan);
    if (!report) return 0;
    sum += static_cast<double>(estimated_cost(counts, effects, view, report->plan, work_of(report->statistics)));
  }
  return sum / row.frames;
}

TEST(Estimate, IsNearWhatACortexM3Counts) {
  int judged = 0;
  for (const Row& row : rows()) {
    if (row.target != "m3" || row.depth != "z16" || (row.mode != "streamed" && row.mode != "binned")) continue;
    if (find_workload(row.workload)->built_in() == nullptr) continue;  // its model is not on this machine
    EXPECT_NEAR(estimated(row) / row.counted, 1, 0.15) << row.name;
    ++judged;
  }
  EXPECT_GE(judged, 13);
}

}  // namespace
}  // namespace zstrip::sim
