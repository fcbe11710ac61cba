// `zstrip render`: options, frames, files, report.
#include "cli/render_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "cli/board_arguments.hpp"
#include "cli/drawing_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/output_names.hpp"
#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "cli/scene_drawer.hpp"
#include "image/animated_png.hpp"
#include "image/inputs.hpp"
#include "image/write_file.hpp"
#include "render/empty_picture.hpp"
#include "render/parallel.hpp"
#include "render/stage.hpp"
#include "report/frame_record.hpp"
#include "text/progress.hpp"
#include "text/step_report.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMaxFrames = 10000;  // four digits in the names
constexpr unsigned kMaxThreads = 256;

/// The options as given on the command line.
struct RenderCommandLine {
  DrawingArguments drawing;
  std::optional<std::string> output;
  std::optional<std::uint32_t> frames;
  std::optional<std::uint32_t> threads;
  std::optional<std::string> image;
  std::optional<std::string> json;
  std::optional<std::string> pick;
  bool quiet = false;
};

struct Job {
  Drawing drawing;
  OutputNames outputs;
  std::string report;  ///< the argument of --json, or empty
  unsigned threads = 1;
  std::optional<PixelPlace> pick;
};

/// Returns the format of the written picture: that of the panel's glass, of the strips, or of --show.
PixelFormat shown_format(const Drawing& drawing) {
  if (drawing.visibility.show != Show::colour) return PixelFormat::rgb565;
  return drawing.panel ? PixelFormat::xrgb8888 : drawing.view.format;
}

/// Parses "120,80".
Result<PixelPlace> parse_place(const std::string& text) {
  PixelPlace place;
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, place.x);
  if (x.ec == std::errc() && x.ptr != end && *x.ptr == ',') {
    const auto y = std::from_chars(x.ptr + 1, end, place.y);
    if (y.ec == std::errc() && y.ptr == end) return place;
  }
  return usage(fmt::format("--pick '{}' is not a pixel X,Y, for example 120,80", printable(text)));
}

Result<Job> parse(const RenderCommandLine& arguments) {
  const std::string& scene = arguments.drawing.scene;
  const Result<PictureSettings> settings = settings_of(scene);
  if (!settings) return settings.failure();
  Result<Drawing> drawing = parse_drawing(arguments.drawing, *settings);
  if (!drawing) return drawing.failure();
  std::optional<ImageType> type;
  if (arguments.image) {
    const Result<ImageType> parsed = parse_image_type(*arguments.image);
    if (!parsed) return parsed.failure();
    type = *parsed;
  }
  Result<OutputNames> outputs = name_outputs(scene, arguments.output, arguments.frames, type, shown_format(*drawing),
                                             settings->frames.value_or(kFolderFrames));
  if (!outputs) return outputs.failure();
  if (const Result<Done> distinct = check_distinct(*outputs, arguments.json); !distinct) return distinct.failure();
  const unsigned threads =
      arguments.threads ? *arguments.threads : std::clamp(std::thread::hardware_concurrency(), 1U, kMaxThreads);
  std::optional<PixelPlace> pick;
  if (arguments.pick) {
    const Result<PixelPlace> parsed = parse_place(*arguments.pick);
    if (!parsed) return parsed.failure();
    if (drawing->visibility.method.methods != 0)
      return usage("--pick finds what the z-buffer shows; leave out --visibility");
    pick = *parsed;
  }
  return Job{std::move(*drawing), std::move(*outputs), arguments.json.value_or(""), threads, pick};
}

/// Returns the reason why nothing of the scene is visible, or nearly nothing of a model; empty if it is visible.
std::string words_of_emptiness(Stage& stage, const Job& job, const RunRecord& run) {
  const std::string too_small = job.drawing.camera.placed() ? "" : why_too_small(stage, job.drawing.view);
  const bool drawn =
      std::ranges::any_of(run.frames, [](const FrameRecord& frame) { return frame.report.statistics.fragments > 0; });
  if (!too_small.empty()) return (drawn ? "most of the model is not seen: " : "no pixel was drawn: ") + too_small;
  if (!drawn && is_below_a_pixel(stage, job.drawing.view)) {
    return "no pixel was drawn: all that the camera sees is smaller than a pixel; bring it nearer, or make --size "
           "larger";
  }
  if (!drawn) {
    return fmt::format("no pixel was drawn: the camera does not see the scene; check --eye, --orbit, --look-at{}",
                       kind_of_scene(run.scene) == SceneKind::model ? ", --up" : "");
  }
  const std::uint32_t first = run.frames.front().report.crc32;
  const bool all_alike =
      std::ranges::all_of(run.frames, [first](const FrameRecord& frame) { return frame.report.crc32 == first; });
  if (!all_alike || job.drawing.visibility.show != Show::colour || !is_background(stage, job.drawing.view, first))
    return {};
  return "nothing is seen in the picture: " + why_unseen(stage);
}

/// Explains an empty picture, which looks like an error of the renderer.
void warn_if_empty(Stage& stage, const Job& job, RunRecord& run) {
  std::string warning = words_of_emptiness(stage, job, run);
  if (warning.empty()) return;
  print_warning(warning);
  run.warnings.push_back(std::move(warning));
}

/// Warns of inputs that the real panel might not accept, such as a fast clock.
void warn_of_complaints(const PanelModel& panel, RunRecord& run) {
  for (const std::string& complaint : panel.complaints()) {
    run.warnings.push_back("the panel may not do this: " + complaint);
    print_warning(run.warnings.back());
  }
}

std::optional<PanelRecord> panel_record(const std::optional<PanelRequest>& panel) {
  if (!panel) return std::nullopt;
  return PanelRecord{panel->kind->name, bus_words(*panel), 90 * static_cast<int>(panel->orientation.rotation),
                     panel->orientation.mirrored, panel->changes};
}

/// The bytes of a file.
using Picture = std::vector<std::uint8_t>;

/// `kept`: the frames of an animation, which are written as one file.
Result<FrameRecord> render_frame(SceneDrawer& drawer, const Job& job, std::uint32_t frame, std::vector<Picture>& kept) {
  const Result<Staging> staging = drawer.stage().place(frame, job.outputs.frames);
  if (!staging) return staging.failure();
  std::optional<PickedPixel> picked;
  if (job.pick) {
    Result<PickedPixel> found =
        pick_pixel(*staging, drawer.stage().origins(), job.drawing.view, job.drawing.effects(), *job.pick);
    if (!found) return found.failure();
    picked = std::move(*found);
  }
  const Result<DrawnFrame> drawn = drawer.draw(*staging, job.drawing.visibility.show);
  if (!drawn) return drawn.failure();
  Result<Picture> picture = drawer.encoded(job.outputs.type, *drawn);
  if (!picture) return picture.failure();
  if (frame == 0) {
    if (const Result<Done> prepared = prepare(job.outputs); !prepared) return prepared.failure();
  }
  const std::filesystem::path file = job.outputs.file(frame);
  if (job.outputs.is_animated()) {
    kept[frame] = std::move(*picture);
  } else if (const Result<Done> written = write_file(file, *picture, "-o"); !written) {
    return written.failure();
  }
  FrameRecord record{file.string(), drawn->report, drawn->bus, {}, {}, std::move(picked)};
  if (drawn->heat) record.heat = drawn->heat->figures;
  if (job.drawing.visibility.show == Show::error) record.wrong = drawn->shown->wrong;
  return record;
}

/// Several frames are drawn, encoded and written on all threads, one frame on each thread. Of a single frame all
/// threads draw the strips.
Result<RunRecord> render_frames(const std::string& scene, const Job& job, bool quiet) {
  const Drawing& drawing = job.drawing;
  std::optional<StepReport> steps(std::in_place, !quiet);
  const Result<std::unique_ptr<Stage>> stage = open_scene(scene, drawing, job.outputs.frames);
  steps.reset();
  if (!stage) return stage.failure();
  RunRecord run{scene, drawing.view, (*stage)->warnings(), std::vector<FrameRecord>(job.outputs.frames),
                panel_record(drawing.panel)};

  std::optional<VisibleSetFile> sets;
  if (!drawing.visibility.sets.empty()) {
    Result<VisibleSetFile> read = VisibleSetFile::read(drawing.visibility.sets);
    if (!read) return read.failure();
    sets = std::move(*read);
  }
  // Before a picture is written.
  if (const Result<Done> checked = check_no_input(job.report, "--json"); !checked) return checked.failure();
  // Each frame begins with the visible meshlets, or what the panel shows, of the frame before.
  const bool in_order = drawing.visibility.temporal || (drawing.panel && drawing.panel->changes);
  const unsigned threads = in_order ? 1 : std::min(job.threads, job.outputs.frames);
  const unsigned strip_threads = job.outputs.frames == 1 ? job.threads : 1;
  std::vector<SceneDrawer> drawers;
  for (unsigned thread = 0; thread < threads; ++thread) {
    Result<SceneDrawer> drawer = SceneDrawer::open(drawing, (*stage)->copy(), sets ? &*sets : nullptr, strip_threads);
    if (!drawer) return drawer.failure();
    drawers.push_back(std::move(*drawer));
  }
  Progress progress(job.outputs.frames, !quiet);
  std::mutex mutex;  // protects the progress
  std::uint32_t done = 0;
  std::vector<Picture> kept(job.outputs.is_animated() ? job.outputs.frames : 0);
  const auto draw = [&](unsigned thread, std::uint32_t frame) {
    Result<FrameRecord> record = render_frame(drawers[thread], job, frame, kept);
    if (!record) return Result<Done>(record.failure());
    run.frames[frame] = std::move(*record);
    const std::scoped_lock lock(mutex);
    progress.show(++done);
    return Result<Done>(Done{});
  };
  // The first frame creates the folder, because it is then known that the scene can be drawn.
  if (const Result<Done> first = draw(0, 0); !first) return first.failure();
  const Result<Done> others = for_each_on_threads(
      job.outputs.frames - 1, threads, [&](unsigned thread, std::uint32_t index) { return draw(thread, index + 1); });
  if (!others) return others.failure();
  if (job.outputs.is_animated()) {
    const Picture animation = animated_png(kept, milliseconds_of(**stage));
    if (const Result<Done> written = write_file(job.outputs.path, animation, "-o"); !written) return written.failure();
  }
  // The panels of all drawers are equal.
  if (const SimulatedPanel* panel = drawers.front().panel()) warn_of_complaints(panel->model(), run);
  warn_if_empty(**stage, job, run);
  return run;
}

Result<Done> report(const RunRecord& run, const RenderCommandLine& arguments) {
  const bool json_on_stdout = arguments.json && (*arguments.json == "-" || is_standard_output(*arguments.json));
  if (arguments.json) {
    const std::string json = to_json(run);
    if (json_on_stdout) {
      write_text(stdout, json);  // main checks the stream's state
    } else if (const Result<Done> written = write_file(
                   *arguments.json, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}, "--json");
               !written) {
      return written.failure();
    }
  }
  if (arguments.quiet) return Done{};
  const bool stdout_taken = json_on_stdout || (arguments.output && is_standard_output(*arguments.output));
  if (!write_text(stdout_taken ? stderr : stdout, summary(run)) && stdout_taken) {
    return Failure{ExitStatus::output, "cannot write the summary to standard error; is it closed, or the disk full?"};
  }
  return Done{};
}

int run_render(const RenderCommandLine& arguments) {
  const Result<Job> job = parse(arguments);
  if (!job) return print_failure(job.failure());
  Result<RunRecord> record = render_frames(arguments.drawing.scene, *job, arguments.quiet);
  if (!record) return print_failure(record.failure());
  const Result<Done> reported = report(*record, arguments);
  if (!reported) return print_failure(reported.failure());
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("render", "Render a built-in scene, a model or a baked scene to pictures");
  const auto arguments = std::make_shared<RenderCommandLine>();
  RenderCommandLine& a = *arguments;
  add_drawing_options(*command, a.drawing);
  add_board_option(*command, a.drawing.memory.board);
  command
      ->add_option("-o,--output", a.output,
                   "A folder for the frames, or one file: .png .jpg .ppm .pgm .raw, .apng with all "
                   "frames (default: SCENE.png here)")
      ->type_name("DIR|FILE");
  command
      ->add_option(
          "--frames", a.frames,
          "Frames of the animation, or of a full rotation, 1 to 10000 (default: 1 for a picture, 8 for a folder or "
          ".apng)")
      ->option_text("N")
      ->check(CLI::Range(1U, kMaxFrames));
  command
      ->add_option("--threads", a.threads,
                   "Number of threads that draw; the pixels are the same (default: one for each core)")
      ->option_text("N")
      ->check(CLI::Range(1U, kMaxThreads));
  command->add_option("--image", a.image, "Picture files: png (default), jpeg, ppm or raw")
      ->transform(lower_case())
      ->type_name("TYPE");
  command->add_option("--json", a.json, "Write a report of each frame; - is standard output")->type_name("FILE|-");
  command->add_option("--pick", a.pick, "Say which instance, triangle and place in its texture pixel X,Y shows")
      ->type_name("X,Y");
  command->add_flag("--quiet", a.quiet, "No summary, no progress; warnings and errors remain");
  command->footer(
      "Examples:\n"
      "  zstrip render teapot\n"
      "  zstrip render teapot -o out/teapot --frames 64\n"
      "  zstrip render teapot -o turn.apng --frames 64\n"
      "  zstrip render bunny.obj -o bunny.png --size 640x480 --orbit 0.3,45,70\n"
      "  zstrip render knot_meshlets --ram 20K --json -\n"
      "  zstrip render random50 --visibility painter --show error\n"
      "  zstrip render duck.glb -o oled --size 128x64 --format gray4 --image raw\n"
      "  zstrip render teapot -o panel.png --panel st7789 --bus spi@40MHz --rotation 90\n"
      "  zstrip render teapot -o frames --frames 64 --panel st7789 --changes --json frames.json\n"
      "  zstrip render teapot -o oled.png --panel ssd1306 --bus i2c@400kHz --dither\n"
      "  zstrip render teapot -o smooth.png --samples 4\n"
      "  zstrip render room --size 320x240 --pick 160,120");
  command->callback([arguments, &exit_code] { exit_code = run_render(*arguments); });
}

}  // namespace zstrip::sim
