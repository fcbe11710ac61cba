// The event loop of the window: input changes the drawing, and time selects the frame.
#include "view/view_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/print.hpp"
#include "image/animated_png.hpp"
#include "image/rgb_png.hpp"
#include "image/write_file.hpp"
#include "text/text.hpp"
#include "view/watched_files.hpp"
#include "view/window_picture.hpp"

namespace zstrip::sim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kMaxScale = 8;
constexpr std::uint32_t kWideEnough = 960, kHighEnough = 720;  // limit without a --scale of the user
constexpr double kDegreesOfPixel = 0.4;                        // of a drag, per pixel
constexpr std::uint32_t kTick = 15;                            // milliseconds between two checks of the time
constexpr std::uint32_t kPlayingTick = 4;
constexpr auto kWatchEvery = std::chrono::milliseconds(300);

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

/// Returns the first of SCENE-1, SCENE-2 and so on that does not exist as a file.
std::filesystem::path free_name(const std::string& scene, std::string_view ending) {
  const std::string stem = std::filesystem::path(scene).stem().string();
  for (int number = 1;; ++number) {
    std::filesystem::path name = fmt::format("{}-{}{}", stem, number, ending);
    std::error_code error;
    if (!std::filesystem::exists(name, error)) return name;
  }
}

class ViewLoop {
 public:
  ViewLoop(Viewer& viewer, Window& window, const std::string& scene, WatchedFiles files, const ViewLoopOptions& options)
      : viewer_(viewer),
        window_(window),
        scene_(scene),
        files_(std::move(files)),
        options_(options),
        playing_(options.playing) {}

  Result<Done> run();

 private:
  void take(const Input& input);
  void press(const std::string& key);
  /// Says what is seen at a pixel of the window, on standard output and in the title.
  void pick(const Input& click);
  Result<Done> draw();
  Result<Done> show();
  /// Requests a window for a picture enlarged by `scale`.
  Result<Done> resize(std::uint32_t scale);
  TextLines text() const { return text_ ? TextLines(lines_) : TextLines(); }
  WindowSize picture_size() const { return {shown_.width, shown_.height}; }
  void play(Clock::time_point now);
  void reload();
  void look_at_files(Clock::time_point now);
  void save(const std::filesystem::path& name, const Result<std::vector<std::uint8_t>>& file);
  void save_animation();
  /// True if strips of a board have not all arrived yet.
  bool arriving() const { return arrived_ < viewed_.strips.size(); }

  Viewer& viewer_;
  Window& window_;
  const std::string& scene_;
  WatchedFiles files_;
  ViewLoopOptions options_;
  Clock::time_point looked_{};

  bool open_ = true;
  bool changed_ = true;  // the frame must be drawn
  bool stale_ = true;    // the window does not show it
  bool marks_ = false, text_ = true, keys_ = false, playing_;
  ViewedFrame viewed_{};
  std::vector<std::string> lines_{};  // below the picture
  RgbImage shown_{};                  // the part of the picture that has arrived at the board's display
  RgbImage pixels_{};                 // the window's pixels
  WindowSize asked_for_{};            // the picture's size when the window's size was requested
  std::size_t arrived_ = 0;
  std::size_t drawing_ = SIZE_MAX;
  Clock::time_point begun_{}, stepped_{};
};

bool closes(const Input& input) {
  return input.kind == Input::Kind::closed || input.key == "q" || input.key == "Escape";
}

struct Key {
  std::string_view name;
  std::string_view does;
};
constexpr std::array kKeys{
    Key{"drag, wheel", "rotate the scene, zoom"},
    Key{"click", "name the part and the triangle there"},
    Key{"c", "back to the scene's own camera"},
    Key{"Space", "play, stop; a scene without motion rotates"},
    Key{"Right, Left", "the next frame, the one before"},
    Key{"w, d, o", "wireframe, depth, how often pixels are drawn; again: colours"},
    Key{"h", "a heat map: how different each pixel looks from the truth; again: colours"},
    Key{"b, t", "the strips' borders, the text below"},
    Key{"+, -", "larger, smaller"},
    Key{"s, S, a", "a picture as zstrip render writes it, one of the window, all frames as an animation"},
    Key{"r", "read the scene again"},
    Key{"k, F1", "these lines; again: the picture"},
    Key{"q, Escape", "quit"},
};
constexpr std::size_t kKeyWidth = 13;
constexpr std::string_view kShortKeys = "k: all keys  drag: rotate  Space: play  q: quit";

Result<Done> ViewLoop::draw() {
  Result<ViewedFrame> viewed = viewer_.draw();
  if (!viewed && viewer_.look() != Look::colour) {
    print_failure(viewed.failure());
    viewer_.toggle(viewer_.look());
    viewed = viewer_.draw();
  }
  if (!viewed) return viewed.failure();
  viewed_ = std::move(*viewed);
  const bool at_once = viewed_.times.empty() || viewed_.strips.empty() || shown_.width != viewed_.picture.width ||
                       shown_.height != viewed_.picture.height;
  if (at_once) shown_ = viewed_.picture;
  lines_ = viewed_.text;
  lines_.emplace_back(kShortKeys);
  arrived_ = at_once ? viewed_.strips.size() : 0;
  begun_ = Clock::now();
  changed_ = false, stale_ = true;
  return Done{};
}

/// Strips arrive with the delay of the board.
void copy_rows(const RgbImage& from, const Rect& area, RgbImage& to) {
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    const auto at = static_cast<std::ptrdiff_t>(
        3 * (static_cast<std::size_t>(y) * from.width + static_cast<std::size_t>(area.left)));
    std::copy_n(from.rgb.begin() + at, 3 * area.width(), to.rgb.begin() + at);
  }
}

Result<Done> ViewLoop::show() {
  const double now = seconds(Clock::now() - begun_);
  for (; arrived_ < viewed_.strips.size() && viewed_.times[arrived_].send_end <= now; ++arrived_) {
    copy_rows(viewed_.picture, viewed_.strips[arrived_], shown_);
    stale_ = true;
  }
  const auto is_drawn = [now](const StripTimes& strip) { return strip.draw_begin <= now && now < strip.draw_end; };
  const auto drawing = std::ranges::find_if(viewed_.times, is_drawn);
  const std::size_t lit =
      drawing == viewed_.times.end() ? SIZE_MAX : static_cast<std::size_t>(drawing - viewed_.times.begin());
  stale_ = stale_ || (marks_ && lit != drawing_);
  drawing_ = lit;
  if (!stale_) return Done{};
  stale_ = false;
  if (asked_for_ != picture_size()) {
    const std::uint32_t fits = std::min(kWideEnough / shown_.width, kHighEnough / shown_.height);
    const Result<Done> resized = resize(options_.scale == 0 ? fits : options_.scale);
    if (!resized) return resized.failure();
  }
  const WindowSize size = window_.size();
  const StripMarks marks{marks_ ? std::span<const Rect>(viewed_.strips) : std::span<const Rect>{}, drawing_};
  pixels_ = keys_ ? text_page(view_keys(), kKeyWidth, size) : window_picture(shown_, marks, text(), size);
  return window_.show(pixels_);
}

Result<Done> ViewLoop::resize(std::uint32_t scale) {
  asked_for_ = picture_size();
  return window_.resize(wanted_window(asked_for_, std::clamp(scale, 1U, kMaxScale), text(), window_.room()));
}

void ViewLoop::play(Clock::time_point now) {
  const double frame = static_cast<double>(viewer_.milliseconds()) / 1e3 / viewer_.frames();
  const double passed = std::floor(seconds(now - stepped_) / frame);
  if (!playing_ || arriving() || passed < 1) return;
  // Frames that a slow board has no time for are left out.
  viewer_.step(static_cast<std::int64_t>(passed));
  stepped_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(passed * frame));
  changed_ = true;
}

void ViewLoop::look_at_files(Clock::time_point now) {
  if (!options_.watch || now - looked_ < kWatchEvery) return;
  looked_ = now;
  if (files_.changed()) reload();
}

void ViewLoop::save(const std::filesystem::path& name, const Result<std::vector<std::uint8_t>>& file) {
  if (!file) {
    print_failure(file.failure());
  } else if (const Result<Done> written = write_file(name, *file, "cd"); !written) {
    print_failure(written.failure());
  } else {
    write_text(stdout, name.string() + "\n");
    std::fflush(stdout);
  }
}

void ViewLoop::save_animation() {
  const std::int64_t frame = viewer_.frame(), frames = viewer_.frames();
  std::vector<std::vector<std::uint8_t>> files;
  viewer_.step(-frame);
  Result<Done> drawn = Done{};
  for (std::int64_t i = 0; i < frames && drawn; ++i, viewer_.step(1)) {
    window_.set_title(fmt::format("zstrip: saving frame {} of {}", i + 1, frames));
    Result<ViewedFrame> viewed = viewer_.draw();
    if (viewed) {
      files.push_back(std::move(viewed->png));
    } else {
      drawn = viewed.failure();
    }
  }
  viewer_.step(frame - viewer_.frame());
  window_.set_title("zstrip: " + scene_);
  if (drawn) {
    save(free_name(scene_, ".apng"), animated_png(files, viewer_.milliseconds()));
  } else {
    print_failure(drawn.failure());
  }
  changed_ = true;
}

void ViewLoop::press(const std::string& key) {
  const auto look = [this](Look as) {
    viewer_.toggle(as);
    changed_ = true;
  };
  const auto scale = [this] { return static_cast<int>(scale_in(window_.size(), picture_size(), text()).enlarged); };
  const auto ask_for = [this](int to) {
    options_.scale = static_cast<std::uint32_t>(std::max(to, 1));
    asked_for_ = {};
    stale_ = true;
  };
  const auto step = [this](std::int64_t frames) {
    viewer_.step(frames);
    changed_ = true, playing_ = false;
  };
  if (closes({.kind = Input::Kind::key, .key = key})) open_ = false;
  if (key == "Right") step(1);
  if (key == "Left") step(-1);
  if (key == "Space") playing_ = !playing_, stepped_ = Clock::now();
  if (key == "c") viewer_.reset_camera(), changed_ = true;
  if (key == "w") look(Look::wireframe);
  if (key == "d") look(Look::depth);
  if (key == "o") look(Look::overdraw);
  if (key == "h") look(Look::accuracy);
  if (key == "b") marks_ = !marks_, stale_ = true;
  if (key == "k" || key == "F1") keys_ = !keys_, stale_ = true;
  if (key == "t") {
    const int now = scale();
    text_ = !text_;
    ask_for(now);
  }
  if (key == "+" || key == "=" || key == "Keypad +") ask_for(scale() + 1);
  if (key == "-" || key == "Keypad -") ask_for(scale() - 1);
  if (key == "s") save(free_name(scene_, ".png"), viewed_.png);
  if (key == "S") save(free_name(scene_, ".png"), encode_rgb_png(pixels_));
  if (key == "a") save_animation();
  if (key == "r") reload();
}

void ViewLoop::pick(const Input& click) {
  const std::optional<PicturePixel> pixel = pixel_at(
      window_.size(), picture_size(), text(), static_cast<std::int64_t>(click.x), static_cast<std::int64_t>(click.y));
  if (!pixel || keys_) return;
  const Result<std::string> words =
      viewer_.pick({static_cast<std::uint16_t>(pixel->x), static_cast<std::uint16_t>(pixel->y)});
  if (!words) {
    print_failure(words.failure());
    return;
  }
  window_.set_title(fmt::format("zstrip: {}: {}", scene_, *words));
  write_text(stdout, fmt::format("{},{}: {}\n", pixel->x, pixel->y, *words));
  std::fflush(stdout);
}

void ViewLoop::reload() {
  WatchedFiles files(scene_);
  if (const Result<Done> loaded = viewer_.reload(); !loaded) {
    print_failure(loaded.failure());
    return;
  }
  files_ = std::move(files);
  changed_ = true;
}

void ViewLoop::take(const Input& input) {
  switch (input.kind) {
    case Input::Kind::key: press(input.key); break;
    case Input::Kind::drag:
      viewer_.turn(input.x * kDegreesOfPixel, input.y * kDegreesOfPixel);
      changed_ = true;
      break;
    case Input::Kind::click: pick(input); break;
    case Input::Kind::wheel:
      viewer_.zoom(input.y);
      changed_ = true;
      break;
    case Input::Kind::exposed: stale_ = true; break;
    case Input::Kind::closed: open_ = false; break;
  }
}

Result<Done> ViewLoop::run() {
  auto next = options_.inputs.begin();
  std::optional<Input> key;  // pressed before the picture that it applies to was drawn
  bool first = true;
  while (open_) {
    // All strips of a frame arrive before the next frame is drawn.
    if (changed_ && !arriving()) {
      const Result<Done> drawn = draw();
      if (!drawn && first) return drawn.failure();
      if (!drawn) {
        print_failure(drawn.failure());
        changed_ = playing_ = false;
      }
      if (std::exchange(first, false)) stepped_ = Clock::now();
    }
    if (const Result<Done> shown = show(); !shown) return shown.failure();
    if (key && !changed_) {
      take(*std::exchange(key, std::nullopt));
      continue;
    }
    if (next != options_.inputs.end() && (!arriving() || closes(*next))) window_.inject(*next++);
    // Many small drags are added up; a key applies to the visible picture.
    std::optional<Input> input = window_.wait(playing_ ? kPlayingTick : kTick);
    for (; input && input->kind != Input::Kind::key; input = window_.wait(0)) take(*input);
    if (input && changed_ && !closes(*input)) {
      key = input;
    } else if (input) {
      take(*input);
    }
    play(Clock::now());
    look_at_files(Clock::now());
  }
  return Done{};
}

}  // namespace

std::vector<std::string> view_keys() {
  std::vector<std::string> lines;
  for (const Key& key : kKeys) lines.push_back(fmt::format("{:<{}}{}", key.name, kKeyWidth, key.does));
  return lines;
}

Result<Done> run_view_loop(Viewer& viewer, Window& window, const std::string& scene, WatchedFiles files,
                           const ViewLoopOptions& options) {
  return ViewLoop(viewer, window, scene, std::move(files), options).run();
}

}  // namespace zstrip::sim
