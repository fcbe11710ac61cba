// The functions that the page calls: the command, and the viewer without a window. One scene is open at a time.
#include <emscripten.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/bake_command.hpp"
#include "cli/command_line.hpp"
#include "cli/print.hpp"
#include "cli/render_command.hpp"
#include "cli/usage_error.hpp"
#include "compose/perspective_runs.hpp"
#include "image/to_rgb.hpp"
#include "plan/depth_advice.hpp"
#include "play/left_out.hpp"
#include "report/frame_record.hpp"
#include "report/heat_json.hpp"
#include "report/ram_json.hpp"
#include "view/view_arguments.hpp"
#include "view/viewer.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

// The page has no visibility methods, but counts how often pixels are drawn.
[[maybe_unused]] const bool kCounts = (use_overdraw_counts(), true);

std::optional<Viewer> viewer;
ViewedFrame viewed;
std::vector<std::uint8_t> rgba;
std::string answer;

/// Valid until the next answer.
const char* answered(const Json& json) {
  answer = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return answer.c_str();
}

const char* answered(const Failure& failure) {
  return answered(Json{{"error", failure.message}, {"status", static_cast<int>(failure.status)}});
}

Result<ViewRequest> parse(const std::string& words) {
  ViewOptions options;
  CLI::App app{"", "zstrip"};
  add_view_options(app, options);
  std::vector<std::string> arguments;
  std::istringstream lines(words);
  for (std::string word; std::getline(lines, word);) arguments.insert(arguments.begin(), word);
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return Failure{ExitStatus::usage, usage_error(app, error)};
  }
  if (const std::optional<Failure> failure = left_out(options.drawing.scene)) return *failure;
  Result<ViewRequest> request = parse_view_request(options);
  if (request) request->smooth = !options.frames;
  return request;
}

/// The values of the options that are not given: those of the scene and of the panel, or else the command's; none if
/// these do not go together.
Json defaults_of(const ViewRequest& request) {
  const std::string& scene = request.drawing.scene;
  const Result<PictureSettings> settings = settings_of(scene);
  if (!settings) return Json::object();
  const DrawingArguments none{.scene = scene, .panel = request.drawing.panel};
  const Result<Drawing> drawing = parse_drawing(none, *settings);
  if (!drawing) return Json::object();
  const View& view = drawing->view;
  const auto* const run =
      std::ranges::find(kPerspectiveRuns, drawing->perspective, [](auto& each) { return each.second; });
  Json defaults{
      {"size", fmt::format("{}x{}", view.width, view.height)},
      {"format", name(view.format)},
      {"dither", view.dither},
      {"samples", view.samples},
      {"edges", drawing->edges.value_or(false)},
      {"depth-format", name(drawing->depth_format)},
      {"perspective", run->first},
      {"frames", viewer->frames()},
  };
  if (drawing->ram_limit == RamLimit::given && drawing->budget.bytes != 0) defaults["ram"] = drawing->budget.bytes;
  if (drawing->budget.strip_rows != 0) defaults["strip-rows"] = drawing->budget.strip_rows;
  if (kind_of_scene(scene) == SceneKind::model) {
    const Colour& colour = drawing->model.look.background;
    defaults["background"] = fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
  }
  return defaults;
}

Json boards() {
  Json boards = Json::object();
  for (const BoardModel& board : board_models()) boards[std::string(board.name)] = board.description;
  return boards;
}

/// Converts to the pixels of ImageData: red, green, blue, and opaque alpha.
void convert_pixels(const RgbImage& picture) {
  rgba.resize(picture.rgb.size() / 3 * 4);
  for (std::size_t from = 0, to = 0; from < picture.rgb.size(); from += 3, to += 4) {
    for (std::size_t i = 0; i < 3; ++i) rgba[to + i] = picture.rgb[from + i];
    rgba[to + 3] = 255;
  }
}

Json strips_of_frame() {
  Json strips = Json::array();
  for (std::size_t i = 0; i < viewed.strips.size(); ++i) {
    const Rect& area = viewed.strips[i];
    Json strip{{"left", area.left}, {"top", area.top}, {"right", area.right}, {"bottom", area.bottom}};
    if (i < viewed.times.size()) {
      strip["draw_begin"] = viewed.times[i].draw_begin;
      strip["draw_end"] = viewed.times[i].draw_end;
      strip["send_end"] = viewed.times[i].send_end;
    }
    strips.push_back(strip);
  }
  return strips;
}

Json rates_of_frame() {
  Json rates = Json::object();
  for (const BoardRate& rate : viewed.rates) rates[std::string(rate.board)] = rate.words();
  return rates;
}

/// Returns null if the frame was not compared with the truth. `key`: some differences and their colours.
Json accuracy_of_frame() {
  if (!viewed.heat) return nullptr;
  Json key = Json::array();
  for (const float difference : {0, 1, 2, 5, 10, 20}) {
    const auto [r, g, b] = heat_colour(difference);
    key.push_back({difference, fmt::format("#{:02x}{:02x}{:02x}", r, g, b)});
  }
  Json accuracy = heat_json(*viewed.heat);
  accuracy["key"] = key;
  return accuracy;
}

}  // namespace

extern "C" {

/// `words`: the scene and the options of `zstrip view`, one a line. All answers are JSON: the result, or
/// {"error", "status"}; after an error the last scene stays open.
EMSCRIPTEN_KEEPALIVE const char* zstrip_open(const char* words) {
  const Result<ViewRequest> request = parse(words);
  if (!request) return answered(request.failure());
  Result<Viewer> opened = Viewer::open(*request);
  if (!opened) return answered(opened.failure());
  viewer.emplace(std::move(*opened));
  return answered(Json{{"frames", viewer->frames()},
                       {"milliseconds", viewer->milliseconds()},
                       {"moves", viewer->moves()},
                       {"defaults", defaults_of(*request)},
                       {"boards", boards()}});
}

EMSCRIPTEN_KEEPALIVE void zstrip_turn(double yaw, double pitch) {
  if (viewer) viewer->turn(yaw, pitch);
}
EMSCRIPTEN_KEEPALIVE void zstrip_zoom(double steps) {
  if (viewer) viewer->zoom(steps);
}
EMSCRIPTEN_KEEPALIVE void zstrip_reset_camera() {
  if (viewer) viewer->reset_camera();
}
EMSCRIPTEN_KEEPALIVE void zstrip_step(int frames) {
  if (viewer) viewer->step(frames);
}
/// 0 to 4: colours, wireframe, depth, overdraw, accuracy.
EMSCRIPTEN_KEEPALIVE void zstrip_look(int look) {
  if (viewer && viewer->look() != static_cast<Look>(look)) viewer->toggle(static_cast<Look>(look));
}

/// The frame's figures.
EMSCRIPTEN_KEEPALIVE const char* zstrip_draw() {
  if (!viewer) return answered(Failure{ExitStatus::usage, "no scene is open"});
  Result<ViewedFrame> drawn = viewer->draw(false);
  if (!drawn) return answered(drawn.failure());
  viewed = std::move(*drawn);
  convert_pixels(viewed.picture);
  const FrameReport& report = viewed.report;
  return answered(Json{
      {"width", viewed.picture.width},
      {"height", viewed.picture.height},
      {"frame", viewer->frame()},
      {"mode", name(report.mode)},
      {"strips", strips_of_frame()},
      {"ram_bytes", ram_bytes(report)},
      {"flash_bytes", viewed.flash_bytes},
      {"triangles", report.statistics.triangles},
      {"drawn", report.statistics.drawn},
      {"fragments", report.statistics.fragments},
      {"m3_instructions", viewed.instructions},
      {"estimate_leaves_out", viewed.left_out},
      {"rates", rates_of_frame()},
      {"accuracy", accuracy_of_frame()},
      {"text", viewed.text},
  });
}

/// Names what a pixel of the picture shows, in the words of `zstrip view`: {"words"}.
EMSCRIPTEN_KEEPALIVE const char* zstrip_pick(int x, int y) {
  if (!viewer) return answered(Failure{ExitStatus::usage, "no scene is open"});
  const Result<std::string> words = viewer->pick({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
  if (!words) return answered(words.failure());
  return answered(Json{{"words", *words}});
}

/// Returns the frame that was drawn last, four bytes a pixel.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* zstrip_pixels() { return rgba.data(); }

/// Returns the length of that frame's file, as `zstrip render` writes it, which zstrip_png() then returns; 0 without
/// one.
EMSCRIPTEN_KEEPALIVE std::size_t zstrip_png_bytes() {
  if (!viewer) return 0;
  Result<ViewedFrame> drawn = viewer->draw(true);
  if (!drawn) return 0;
  viewed.png = std::move(drawn->png);
  return viewed.png.size();
}
EMSCRIPTEN_KEEPALIVE const std::uint8_t* zstrip_png() { return viewed.png.data(); }

}  // extern "C"

}  // namespace zstrip::sim

/// The command, for what it writes: pictures, headers and blobs.
int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (const auto failure = zstrip::sim::left_out(argv[i])) return zstrip::sim::print_failure(*failure);
  }
  return zstrip::sim::run_command_line(argc, argv, [](CLI::App& app, int& exit_code) {
    zstrip::sim::add_render_command(app, exit_code);
    zstrip::sim::add_bake_command(app, exit_code);
  });
}
