// The state of the view: frame, camera, look, and the cost of the frame on a device.
#include "view/viewer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "bake/stage_skins.hpp"
#include "bench/board_estimate.hpp"
#include "image/encode.hpp"
#include "image/to_rgb.hpp"
#include "plan/staged_cost.hpp"
#include "report/plan_words.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr double kZoomStep = 1.1;
constexpr double kClosest = 0.05, kFarthest = 20;
constexpr std::uint32_t kSmooth = 30;  // frames a second, approximately
constexpr std::uint32_t kMaxFrames = 10000;

/// True if pixels of the picture and the panel have the same coordinates.
bool lies_upright(const std::optional<PanelRequest>& panel) {
  return !panel || (panel->orientation.rotation == hal::Rotation::none && !panel->orientation.mirrored);
}

}  // namespace

Result<Viewer> Viewer::open(const ViewRequest& request) {
  Viewer viewer(request);
  if (const Result<Done> loaded = viewer.reload(); !loaded) return loaded.failure();
  return viewer;
}

Result<Done> Viewer::reload() {
  const std::string& scene = request_.drawing.scene;
  const Result<PictureSettings> settings = settings_of(scene);
  if (!settings) return settings.failure();
  Result<Drawing> parsed = parse_drawing(request_.drawing, *settings);
  if (!parsed) return parsed.failure();
  auto drawing = std::make_unique<Drawing>(std::move(*parsed));
  if (request_.board != nullptr && drawing->ram_limit == RamLimit::usual) {
    drawing->budget.bytes = request_.board->ram_bytes - kReservedRam;
    drawing->budget.strip_buffers = request_.board->dma ? 2 : 1;
  }
  Result<std::unique_ptr<Stage>> stage = open_scene(scene, *drawing, request_.frames);
  if (!stage) return stage.failure();
  std::unique_ptr<VisibleSetFile> sets;
  if (!drawing->visibility.sets.empty()) {
    Result<VisibleSetFile> read = VisibleSetFile::read(drawing->visibility.sets);
    if (!read) return read.failure();
    sets = std::make_unique<VisibleSetFile>(std::move(*read));
  }
  Result<SceneDrawer> drawer = SceneDrawer::open(*drawing, std::move(*stage), sets.get(), 1);
  if (!drawer) return drawer.failure();
  drawer_.reset();
  drawing_ = std::move(drawing);
  sets_ = std::move(sets);
  drawer_.emplace(std::move(*drawer));
  frames_ = request_.frames;
  // The tree of a scene is made for its number of frames.
  if (request_.smooth && moves() && !drawing_->visibility.method.has(method::bsp)) {
    frames_ = std::clamp(milliseconds() / (1000 / kSmooth), frames_, kMaxFrames);
  }
  frame_ %= frames_;
  return Done{};
}

bool Viewer::moves() const {
  const Stage& stage = drawer_->stage();
  return frames_ > 1 && (!stage.animation().tracks.empty() || stage.bends());
}

void Viewer::step(std::int64_t frames) {
  const std::int64_t all = frames_;
  frame_ = static_cast<std::uint32_t>(((frame_ + frames) % all + all) % all);
}

void Viewer::turn(double yaw, double pitch) {
  orbiting_.yaw = std::remainder(orbiting_.yaw + yaw, 360.0);
  orbiting_.pitch += pitch;
}

void Viewer::zoom(double steps) {
  orbiting_.distance = std::clamp(orbiting_.distance * std::pow(kZoomStep, -steps), kClosest, kFarthest);
}

Result<Staging> Viewer::placed() {
  Result<Staging> staging = drawer_->stage().place(frame_, frames_);
  if (staging) staging->camera = orbited(staging->camera, orbiting_, drawer_->stage().orbit_limits());
  return staging;
}

Result<std::string> Viewer::pick(PixelPlace pixel) {
  if (!lies_upright(drawing_->panel)) {
    return Failure{ExitStatus::usage, "a click says what is there only on a panel that does not rotate its picture"};
  }
  const Result<Staging> staging = placed();
  if (!staging) return staging.failure();
  const Result<PickedPixel> picked =
      pick_pixel(*staging, drawer_->stage().origins(), drawing_->view, drawing_->effects(), pixel);
  if (!picked) return picked.failure();
  return words_of(*picked);
}

Result<ViewedFrame> Viewer::draw(bool with_png) {
  const Result<Staging> at_rest = drawer_->stage().place(frame_, frames_);
  if (!at_rest) return at_rest.failure();
  orbiting_ = within_limits(at_rest->camera, orbiting_, drawer_->stage().orbit_limits());
  const Result<Staging> staging = placed();
  if (!staging) return staging.failure();
  const Result<DrawnFrame> drawn = drawer_->draw(*staging, drawing_->visibility.show);
  if (!drawn) return drawn.failure();
  const SimulatedPanel* panel = drawer_->panel();
  ViewedFrame viewed{.picture = panel != nullptr ? panel->model().seen() : rgb_image_of(drawing_->view, drawn->pixels),
                     .png = {},
                     .report = drawn->report,
                     .strips = strips_of(drawn->report.plan, drawing_->view),
                     .times = {},
                     .left_out = {},
                     .rates = {},
                     .heat = {},
                     .text = {}};
  const Stage& stage = drawer_->stage();
  viewed.flash_bytes = scene_flash(stage, *staging);
  const Effects effects = effects_of(staging->scene, staging->camera) | effects_of(drawing_->view);
  viewed.instructions = staged_cost(*staging, count(staging->scene), effects, drawing_->view, viewed.report.plan,
                                    work_of(viewed.report.statistics));
  viewed.left_out = left_out_of_estimates(effects);
  const EstimatedFrame estimated{viewed.report.plan, drawing_->view, viewed.instructions};
  if (const BoardModel* const board = request_.board) {
    viewed.times = times_on(*board, board->cycles_per_estimate.high, request_.bus_mhz, estimated);
  }
  for (const BoardModel& board : board_models()) {
    viewed.rates.push_back(rate_on(board, &board == request_.board ? request_.bus_mhz : board.spi_mhz, estimated));
  }
  viewed.text = text(viewed);
  Result<std::vector<std::uint8_t>> png = std::vector<std::uint8_t>{};
  if (look_ == Look::accuracy) {
    const Result<DrawnFrame> compared = drawer_->draw(*staging, Show::accuracy);
    if (!compared) return compared.failure();
    if (with_png) png = drawer_->encoded(ImageType::png, *compared);
    viewed.picture = rgb_image_of(compared->view, compared->pixels);
    viewed.heat = compared->heat->figures;
    viewed.text.push_back(in_words(*viewed.heat));
  } else if (look_ != Look::colour) {
    // The cost on a device is that of the scene's normal picture.
    const Result<LookPicture> look = draw_look(*staging, look_, drawing_->view);
    if (!look) return look.failure();
    if (with_png) png = encode(ImageType::png, look->view, look->pixels);
    viewed.picture = rgb_image_of(look->view, look->pixels);
  } else {
    if (with_png) png = drawer_->encoded(ImageType::png, *drawn);
    if (!lies_upright(drawing_->panel)) viewed.strips.clear();
  }
  if (!png) return png.failure();
  viewed.png = std::move(*png);
  return viewed;
}

std::vector<std::string> Viewer::text(const ViewedFrame& viewed) const {
  const FrameReport& report = viewed.report;
  const View& view = drawing_->view;
  std::vector<std::string> lines{
      fmt::format("{}x{} {} {}  {} of {}", view.width, view.height, name(view.format), name_of(look_), frame_ + 1,
                  frames_),
      fmt::format("RAM {} in {} of {}x{}", counted(report.plan.bytes() + report.strip_pixel_bytes, "byte"),
                  counted(report.plan.strips, "strip"), report.plan.strip_columns, report.plan.strip_rows),
      fmt::format("flash {} of scene", counted(viewed.flash_bytes, "byte")),
      fmt::format("{}, {} drawn, {}", counted(report.statistics.triangles, "triangle"),
                  grouped(report.statistics.drawn), counted(report.statistics.fragments, "fragment"))};
  if (const BoardModel* const board = request_.board) {
    const BoardRate& rate = *std::ranges::find(viewed.rates, board->name, &BoardRate::board);
    if (!rate.fits()) {
      lines.push_back(fmt::format("{}: {} of RAM, has {} KB", board->name, rate.words(), board->ram_bytes / 1024));
    } else {
      const BoardTime time =
          time_on(*board, board->cycles_per_estimate.high, request_.bus_mhz, {report.plan, view, viewed.instructions});
      lines.push_back(fmt::format("{}: {:.0f} ms drawn{}, {:.0f} sent: about {} fps", board->name, 1e3 * time.draw,
                                  rate.least < rate.most ? " at most" : "", 1e3 * time.send, rate.words()));
    }
  } else {
    // Other boards are shown with --board.
    std::vector<std::string> boards;
    for (const BoardRate& rate : std::span(viewed.rates).first(boards_with_core_model().size()))
      boards.push_back(fmt::format("{} {}", rate.board, rate.words()));
    lines.push_back(fmt::format("about fps: {}", fmt::join(boards, ", ")));
  }
  if (!viewed.left_out.empty()) {
    lines.push_back(fmt::format("the estimate leaves out: {}", fmt::join(viewed.left_out, ", ")));
  }
  return lines;
}

}  // namespace zstrip::sim
