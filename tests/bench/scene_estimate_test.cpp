// Estimated instructions of the scenes of the gallery and of effects, against those that an emulated Cortex-M3 counts.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "cli/picture_arguments.hpp"
#include "effects/cost/list.hpp"
#include "measured/table.hpp"
#include "plan/staged_cost.hpp"
#include "render/edged_stage.hpp"
#include "render/render_frame.hpp"
#include "render/stage.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::sim {
namespace {

using measured::kExact;

double estimate(const Staging& staging, const View& view, const FrameReport& report) {
  const Effects effects = effects_of(staging.scene, staging.camera) | effects_of(view);
  return static_cast<double>(
      staged_cost(staging, count(staging.scene), effects, view, report.plan, work_of(report.statistics)));
}

/// The mean of the frames that tests/gallery counts, in strips of so many rows.
double estimate_of_scene_file(const std::string& path, std::uint16_t strip_rows) {
  constexpr std::uint32_t kFrames = 4;
  const Result<PictureSettings> settings = settings_of(path);
  if (!settings) throw std::runtime_error(settings.failure().message);
  const View view{
      .width = 240, .height = 240, .format = PixelFormat::rgb565_swapped, .samples = settings->samples.value_or(1)};
  auto stage = open_stage(path, {}, {}, view, kFrames);
  if (stage) stage = with_edges(std::move(*stage), settings->edges, view);
  if (!stage) throw std::runtime_error(stage.failure().message);
  FrameRenderer renderer(view, {.strip_rows = strip_rows, .modes = Modes::streamed});
  double sum = 0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    const Result<Staging> staging = (*stage)->place(frame, kFrames);
    if (!staging) throw std::runtime_error(staging.failure().message);
    const Result<FrameReport> report = renderer.render(*staging);
    if (!report) throw std::runtime_error(report.failure().message);
    sum += estimate(*staging, view, *report);
  }
  return sum / kFrames;
}

TEST(Estimate, OfTheGalleryIsNearWhatACortexM3Counts) {
  const measured::Table counted = measured::read_table(ZSTRIP_GALLERY, {.part = "gallery",
                                                                        .columns = {{"scene"},
                                                                                    {"machine"},
                                                                                    {"preset"},
                                                                                    {"ram_kilobytes"},
                                                                                    {"strip_rows", kExact},
                                                                                    {"instructions", kExact},
                                                                                    {"instructions_at_most", kExact},
                                                                                    {"flash_bytes", kExact}}});
  int judged = 0;
  for (const measured::Row& row : counted.rows) {
    if (row[1] != "m3" || row[2] != "speed") continue;
    const std::string path = std::string(ZSTRIP_SCENE_FILES "/gallery/").append(row[0]).append(".toml");
    const double ratio =
        estimate_of_scene_file(path, static_cast<std::uint16_t>(std::stoi(row[4]))) / std::stod(row[5]);
    EXPECT_NEAR(ratio, 1, 0.15) << row[0] << ", " << row[3] << " KB";
    ++judged;
  }
  EXPECT_GE(judged, 12);
}

double estimate_of_drawing(const effects_cost::Drawing& drawing) {
  FrameRenderer renderer(drawing.view, {.strip_rows = drawing.view.height});
  double sum = 0;
  for (std::uint32_t frame = 0; frame < effects_cost::kFrames; ++frame) {
    scenes::Staged staged;
    stage(*drawing.scene, staged, frame, effects_cost::kFramesPerTurn, drawing.view);
    if (drawing.scene->pose != nullptr && !drawing.scene->pose(frame)) throw std::runtime_error("a pose failed");
    const Staging staging{.scene = staged.scene, .camera = staged.camera};
    const Result<FrameReport> report = renderer.render(staging, drawing.plan);
    if (!report) throw std::runtime_error(report.failure().message);
    sum += estimate(staging, drawing.view, *report);
  }
  return sum / effects_cost::kFrames;
}

TEST(Estimate, OfEffectsIsNearWhatACortexM3Counts) {
  const measured::Table counted = measured::read_table(ZSTRIP_EFFECTS_COST, {.part = "effects",
                                                                             .columns = {{"effect"},
                                                                                         {"machine"},
                                                                                         {"flash", kExact},
                                                                                         {"ram", kExact},
                                                                                         {"instructions", kExact},
                                                                                         {"count", kExact},
                                                                                         {"unit", kExact}}});
  // Not estimated: effects that left_out_of_estimates names, and runs of texels that a user chooses.
  const std::set<std::string> not_estimated{"csg", "overlay", "perspective_affine", "perspective_8", "perspective_1"};
  int judged = 0;
  for (const effects_cost::CostOfEffect& cost : effects_cost::kCosts) {
    const measured::Row* const row = counted.find({std::string(cost.effect), "m3"});
    if (row == nullptr || not_estimated.contains(row->front())) continue;
    const double with = estimate_of_drawing(cost.with), without = estimate_of_drawing(cost.without);
    EXPECT_NEAR(with / (without + std::stod(row->at(4))), 1, 0.15) << row->front();
    ++judged;
  }
  EXPECT_GE(judged, 24);
}

}  // namespace
}  // namespace zstrip::sim
