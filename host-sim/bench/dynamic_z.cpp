// Camera, scene and memory of each row of the dynamic z-buffer's table.
#include "bench/dynamic_z.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

// The paper's figures are those of its one table; where the classic z-buffer cut the picture it has none.
constexpr std::array kPictures{
    DynamicZPicture{100, 4096, true, {1536, 2.57}, {19, 2.78}},
    DynamicZPicture{200, 8192, true, {1536, 11.68}, {78, 12.50}},
    DynamicZPicture{500, 16384, true, {1536, 25.17}, {488, 27.09}},
    DynamicZPicture{1000, 32768, false, {0, 0}, {1953, 92.92}},
    DynamicZPicture{2000, 65536, false, {0, 0}, {7812, 417.92}},
};

constexpr View kDefaultView{1024, 768, PixelFormat::rgb565};
constexpr View kJudgeView{kJudgeSide, kJudgeSide, PixelFormat::rgb565};

// The figure just fills a square picture with this focal length and distance, at every size of the table: tests measure
// the drawn pixels. The focal length is a multiple of the heights of both other views, so that they can have exactly
// the same pixels for a unit: focal * side / height has no remainder.
constexpr Fixed kFocal = 96 * kJudgeSide;  // 16.16
constexpr Fixed kDistance = fixed(5.5165);
static_assert(kFocal % kDefaultView.height == 0 && kFocal % kJudgeView.height == 0);

constexpr std::array kMaterial{Material{.lit = false, .smooth = true}};

// Makes the bounding rectangle of the scene the whole view, as a classic z-buffer has it: a flat box across the view,
// at a distance that lies inside the figure, so that the depth range stays the figure's own. Its one triangle has no
// area: it is culled after one vertex was transformed, and colours no pixel.
constexpr std::array kViewPositions{Position{0, 0, 0}};
constexpr std::array kViewTriangles{Triangle{0, 0, 0}};
constexpr Mesh kWholeView{.positions = kViewPositions,
                          .normals = {},
                          .colours = {},
                          .texcoords = {},
                          .triangles = kViewTriangles,
                          .meshlets = {},
                          .centre = {0, 0, 0},
                          .half_extent = {256 * kFixedOne, 256 * kFixedOne, 0}};

Camera camera_for(const DynamicZPicture& picture, const View& view) {
  Camera camera;
  camera.eye = {0, 0, kDistance};
  camera.focal = static_cast<Fixed>(std::int64_t{kFocal} * picture.side / view.height);
  return camera;
}

}  // namespace

std::span<const DynamicZPicture> dynamic_z_pictures() { return kPictures; }

std::string_view name(DepthMemory memory) {
  switch (memory) {
    case DepthMemory::classic: return "classic";
    case DepthMemory::rectangle: return "rectangle";
    case DepthMemory::small: return "small";
    case DepthMemory::small_and_pixels: break;
  }
  return "small-and-pixels";
}

Budget budget_of(const DynamicZPicture& picture, DepthMemory memory) {
  switch (memory) {
    case DepthMemory::classic: return {.strip_rows = kDefaultView.height};
    case DepthMemory::rectangle: return {.strip_rows = picture.side};
    case DepthMemory::small: return {.bytes = picture.little_bytes, .split_columns = true};
    case DepthMemory::small_and_pixels: break;
  }
  return {.bytes = picture.little_bytes, .split_columns = true, .strip_buffers = 1};
}

DynamicZDrawing::DynamicZDrawing(const TorusKnot& knot, const DynamicZPicture& picture, const View& view,
                                 bool whole_view)
    : view_(view), camera_(camera_for(picture, view)), meshes_(knot.meshes()), effects_{}, renderer_(Effects{}) {
  if (whole_view) meshes_.push_back(kWholeView);
  for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) {
    instances_.push_back({.mesh = static_cast<std::uint16_t>(mesh)});
  }
  effects_ = effects_of(scene(), camera_);
  renderer_ = AnyRenderer(effects_);
}

Scene DynamicZDrawing::scene() const {
  return {.meshes = meshes_, .materials = kMaterial, .textures = {}, .instances = instances_, .lights = {}};
}

Result<DynamicZDrawing> DynamicZDrawing::planned(DynamicZDrawing drawing, const Budget& budget) {
  const auto [status, plan] = zstrip::plan(count(drawing.scene()), drawing.view_, drawing.effects_, budget);
  if (!status) {
    return Failure{ExitStatus::budget,
                   fmt::format("a picture of {}x{} needs {} and has {}: {}", drawing.view_.width, drawing.view_.height,
                               counted(status.needed, "byte"), grouped(status.available), message(status.error))};
  }
  drawing.plan_ = plan;
  drawing.arena_.resize((plan.bytes() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
  drawing.pixels_.resize(std::size_t{plan.strip_rows} * plan.strip_columns);
  return drawing;
}

Result<DynamicZDrawing> DynamicZDrawing::prepare(const TorusKnot& knot, const DynamicZPicture& picture,
                                                 DepthMemory memory) {
  const bool classic = memory == DepthMemory::classic;
  const View view = classic ? kDefaultView : View{picture.side, picture.side, PixelFormat::rgb565};
  return planned(DynamicZDrawing(knot, picture, view, classic), budget_of(picture, memory));
}

Result<DynamicZDrawing> DynamicZDrawing::prepare_judge(const TorusKnot& knot, const DynamicZPicture& picture) {
  return planned(DynamicZDrawing(knot, picture, kJudgeView, false), {.strip_rows = kJudgeView.height});
}

template <typename AfterStrip>
Status DynamicZDrawing::draw_strips(AnyRenderer& renderer, AfterStrip after_strip) {
  const Scene drawn = scene();
  if (const Status begun = renderer.begin_frame(drawn, camera_, view_, plan_, arena()); !begun) return begun;
  for (std::uint16_t strip = 0; strip < plan_.strips; ++strip) {
    if (const Status status = renderer.draw_strip(strip, std::as_writable_bytes(std::span(pixels_))); !status) {
      return status;
    }
    after_strip(plan_.strip_area(strip, view_));
  }
  return {};
}

Status DynamicZDrawing::draw() {
  return draw_strips(renderer_, [](const Rect&) {});
}

Status DynamicZDrawing::draw_into(std::vector<std::uint16_t>& judged) {
  judged.assign(std::size_t{kJudgeSide} * kJudgeSide, 0);  // the background is black
  const std::int32_t left = (kJudgeSide - view_.width) / 2;
  const std::int32_t top = (kJudgeSide - view_.height) / 2;
  return draw_strips(renderer_, [&](const Rect& area) {
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      const auto from = pixels_.begin() + std::ptrdiff_t{y - area.top} * area.width();
      std::copy_n(from, area.width(), judged.begin() + std::ptrdiff_t{top + y} * kJudgeSide + left + area.left);
    }
  });
}

Result<Statistics> DynamicZDrawing::count_work() {
  AnyRenderer counting(effects_ | effect::statistics);
  if (const Status drawn = draw_strips(counting, [](const Rect&) {}); !drawn) {
    return Failure{ExitStatus::internal, fmt::format("the picture could not be drawn: {}", message(drawn.error))};
  }
  return counting.frame().statistics();
}

}  // namespace zstrip::sim
