// The rows of the visibility tables: scenes, sizes, methods, and their measurement.
#include "bench/visibility_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "bench/instruction_count.hpp"
#include "text/progress.hpp"
#include "visibility/methods.hpp"
#include "visibility/numbered_scene.hpp"
#include "visibility/surface_judge.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array<std::string_view, 3> kTables{"midpoint", "thesis", "depth-bits"};
constexpr std::uint32_t kFrame = 7;  // of the workload's motion: an angle without symmetry
constexpr std::uint32_t kRowRounds = 5;

/// The scene of a row.
class RowScene {
 public:
  static Result<std::unique_ptr<RowScene>> of(const VisibilityRowCase& row_case) {
    auto made = std::make_unique<RowScene>();
    if (row_case.scene == kLayers) {
      Result<SoupScene> layers = SoupScene::of(layers_soup());
      if (!layers) return layers.failure();
      made->layers_ = std::move(*layers);
    } else {
      scenes::stage_workload(*scenes::find(row_case.scene), made->staged_, kFrame);
    }
    return made;
  }
  Staging staging() const {
    if (!layers_) return {staged_.scene, staged_.camera};
    Camera camera;
    camera.eye = {0, 0, 0};
    return {layers_->scene(), camera};
  }

 private:
  /// Squares at 8 distances from 2 to 40, 6 pairs each, 1/500 to 1/50,000 of the distance apart. They face the camera,
  /// so that a tolerance for a vertex's place does not change their depth.
  static PolygonSoup layers_soup() {
    PolygonSoup soup;
    soup.double_sided = true;
    double distance = 2;
    for (int row = 0; row < 8; ++row, distance *= 1.534) {
      double apart = distance / 500;
      for (int column = 0; column < 6; ++column, apart /= 2.512) {
        for (int behind = 1; behind >= 0;
             --behind) {  // for equal codes the first square drawn stays, which is the wrong one
          const double size = distance * 0.05, x = distance * 0.16 * (column - 2.5), y = distance * 0.13 * (row - 3.5);
          SoupPolygon square;
          for (const auto& [across, up] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            const double z = -distance - behind * apart;
            square.push_back(
                {{x + size * across, y + size * up, z}, {behind != 0 ? 230.0 : 40.0, behind != 0 ? 60.0 : 200.0, 90}});
          }
          soup.polygons.push_back(std::move(square));
        }
      }
    }
    return soup;
  }

  scenes::Staged staged_;
  std::optional<SoupScene> layers_;
};

Result<MethodRequest> request_of(const VisibilityRowCase& row_case) {
  const Result<VisibilityMethod> method = parse_visibility(row_case.method);
  if (!method) return method.failure();
  MethodRequest request{.view = row_case.view,
                        .budget = {.strip_rows = row_case.view.height, .modes = Modes::streamed},
                        .effects = method->effects | depth_effect(row_case.depth_format),
                        .options = {}};
  request.options.iterations = row_case.iterations;
  return request;
}

Result<std::uint64_t> count_wrong(const Staging& staging, const MethodRequest& request, bool to_the_last_bit) {
  const Result<NumberedScene> numbered = NumberedScene::of(staging.scene);
  if (!numbered) return numbered.failure();
  const Result<LookedAtFrame> drawn = draw_looked_at({numbered->scene(), staging.camera}, request);
  if (!drawn) return drawn.failure();
  SurfaceJudge judge(numbered->scene(), staging.camera, request.view);
  const double code = nearness_of_code(staging.camera, drawn->nearest, drawn->farthest);
  judge.find_nearest({.nearness = to_the_last_bit ? 0 : 1.5 * code});
  std::uint64_t wrong = 0;
  for (const std::uint8_t pixel : wrong_pixels(judge, drawn->pixels, request.view)) wrong += pixel;
  return wrong;
}

}  // namespace

std::span<const std::string_view> visibility_tables() { return kTables; }

std::vector<VisibilityRowCase> rows_of_table(std::string_view table) {
  std::vector<VisibilityRowCase> rows;
  if (table == "midpoint") {
    for (const char* scene : {"random50", "knot_meshlets", "random10k"}) {
      const View view{800, 600, PixelFormat::rgb565};
      for (const char* method : {"zbuffer", "hierarchical-z", "front-to-back-hierarchical-z"}) {
        rows.push_back({scene, view, method});
      }
      for (std::uint8_t n = 0; n <= kMaxIterations; ++n) rows.push_back({scene, view, "midpoint", n});
      rows.push_back({scene, view, "midpoint-safe", 2});
    }
  } else if (table == "thesis") {
    for (const char* scene : {"random50", "random10k"}) {
      for (const View& view : {View{640, 480, PixelFormat::rgb565}, View{1920, 1080, PixelFormat::rgb565}}) {
        for (const char* method : {"painter", "zbuffer", "front-to-back"}) rows.push_back({scene, view, method});
      }
    }
  } else {
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::float16, DepthFormat::z24}) {
      rows.push_back({std::string(kLayers), {800, 600, PixelFormat::rgb565}, "zbuffer", 0, format});
    }
  }
  return rows;
}

Result<VisibilityRow> measure_visibility_row(const VisibilityRowCase& row_case, std::uint32_t rounds) {
  const Result<std::unique_ptr<RowScene>> scene = RowScene::of(row_case);
  if (!scene) return scene.failure();
  const Staging staging = (*scene)->staging();
  const Result<MethodRequest> request = request_of(row_case);
  if (!request) return request.failure();
  const Result<LookedAtFrame> drawn = draw_looked_at(staging, *request);
  if (!drawn) return drawn.failure();
  const bool own_counts = request->effects.methods != 0;
  const Statistics& statistics = drawn->statistics;
  VisibilityRow row{.row_case = row_case,
                    .plan = drawn->plan,
                    .comparisons = own_counts ? drawn->visibility.comparisons : statistics.fragments,
                    .cells_read = drawn->visibility.cells_read,
                    .fragments = statistics.fragments,
                    .writes = statistics.depth_passes,
                    .splits = drawn->pieces_split + drawn->visibility.splits,
                    .instructions = {}};
  const Result<std::uint64_t> wrong = count_wrong(staging, *request, row_case.scene == kLayers);
  if (!wrong) return wrong.failure();
  row.wrong = *wrong;
  // No fragment is black in the numbered scene, for any method.
  const Result<NumberedScene> numbered = NumberedScene::of(staging.scene);
  if (!numbered) return numbered.failure();
  const Result<LookedAtFrame> colours = draw_looked_at({numbered->scene(), staging.camera}, *request);
  if (!colours) return colours.failure();
  row.written = static_cast<std::uint64_t>(
      std::ranges::count_if(colours->pixels, [](std::uint16_t pixel) { return pixel != 0; }));

  Result<TimedDrawing> timed = TimedDrawing::prepare(staging, *request);
  if (!timed) return timed.failure();
  for (std::uint32_t round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    if (const Status status = timed->draw(); !status) {
      return Failure{ExitStatus::internal, fmt::format("a row could not be drawn: {}", message(status.error))};
    }
    const std::chrono::nanoseconds spent = std::chrono::steady_clock::now() - start;
    const auto nanoseconds = static_cast<double>(spent.count());
    if (round == 0 || nanoseconds < row.nanoseconds) row.nanoseconds = nanoseconds;
  }
  return row;
}

Result<std::vector<VisibilityRow>> measure_visibility(std::string_view table) {
  const std::vector<VisibilityRowCase> cases = rows_of_table(table);
  std::vector<VisibilityRow> rows;
  Progress progress(static_cast<std::uint32_t>(cases.size()), true, "row");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Result<VisibilityRow> row = measure_visibility_row(cases[i], kRowRounds);
    if (!row) return row.failure();
    const auto counted = count_draw({"--table", std::string(table), "--table-row", std::to_string(i)},
                                    fmt::format("row {} of the table {}", i, table));
    if (!counted) return counted.failure();
    row->instructions = *counted;
    rows.push_back(std::move(*row));
    progress.show(static_cast<std::uint32_t>(i + 1));
  }
  return rows;
}

Result<Done> draw_visibility_row_only(std::string_view table, std::uint32_t row, std::uint32_t draws) {
  const std::vector<VisibilityRowCase> cases = rows_of_table(table);
  if (row >= cases.size()) return Failure{ExitStatus::usage, "the table has no such row"};
  const Result<std::unique_ptr<RowScene>> scene = RowScene::of(cases[row]);
  if (!scene) return scene.failure();
  const Result<MethodRequest> request = request_of(cases[row]);
  if (!request) return request.failure();
  Result<TimedDrawing> drawing = TimedDrawing::prepare((*scene)->staging(), *request);
  if (!drawing) return drawing.failure();
  for (std::uint32_t i = 0; i < draws; ++i) {
    if (const Status status = drawing->draw(); !status) {
      return Failure{ExitStatus::internal, fmt::format("a row could not be drawn: {}", message(status.error))};
    }
  }
  return Done{};
}

}  // namespace zstrip::sim
