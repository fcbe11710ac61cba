// `zstrip render`: options, frames, files, report.
#include "cli/render_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "cli/camera_arguments.hpp"
#include "cli/output_names.hpp"
#include "cli/panel_arguments.hpp"
#include "cli/parse.hpp"
#include "cli/picture_arguments.hpp"
#include "cli/print.hpp"
#include "cli/visibility_arguments.hpp"
#include "image/animated_png.hpp"
#include "image/write_file.hpp"
#include "render/edged_stage.hpp"
#include "render/empty_picture.hpp"
#include "render/parallel.hpp"
#include "render/render_frame.hpp"
#include "render/stage.hpp"
#include "report/frame_record.hpp"
#include "report/progress.hpp"
#include "report/text.hpp"
#include "visibility/drawing.hpp"
#include "visibility/methods.hpp"
#include "visibility/show.hpp"
#include "visibility/tree_stage.hpp"
#include "visibility/visible_set_file.hpp"
#include "zstrip/effects/exclusions.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMaxFrames = 10000;  // four digits in the names
constexpr unsigned kMaxThreads = 256;

/// As given on the command line.
struct RenderCommandLine {
  std::string scene;
  std::optional<std::string> output;
  ViewArguments view;
  std::optional<std::uint32_t> frames;
  std::optional<std::uint32_t> threads;
  std::optional<std::string> ram;
  std::optional<std::string> strip_rows;
  std::optional<std::string> strip_columns;
  std::optional<std::string> depth_format;
  std::optional<std::string> perspective;
  PanelArguments panel;
  std::optional<std::string> image;
  CameraArguments camera;
  VisibilityArguments visibility;
  std::optional<std::string> json;
  bool quiet = false;
};

struct Job {
  ModelOptions model;
  std::optional<PanelRequest> panel;
  View view;
  std::optional<bool> edges;  ///< of with_edges
  DepthFormat depth_format = DepthFormat::z16;
  std::string_view depth_given;  ///< what has chosen it, for messages
  Effects perspective;
  Budget budget;
  CameraOptions camera;
  VisibilityRequest visibility;
  OutputNames outputs;
  unsigned threads = 1;

  /// Options beside scene, view and method.
  Effects effects() const { return depth_effect(depth_format) | perspective; }
};

/// The picture fills the panel.
View panel_view(const PanelRequest& panel) {
  const bool sideways = is_sideways(panel.orientation);
  const PanelModule& module = panel.module;
  return {sideways ? module.height : module.width, sideways ? module.width : module.height, core_format(panel.format)};
}

/// Of the picture that is written: the panel's glass, or the strips.
PixelFormat shown_format(const Job& job) { return job.panel ? PixelFormat::xrgb8888 : job.view.format; }

/// Some panels take whole groups of rows only.
Result<Done> fit_strips_to_panel(Job& job) {
  const std::uint16_t step = row_step(*job.panel);
  if (step == 1) return Done{};
  if (job.budget.strip_rows == 0) {
    const bool all = job.budget.bytes == 0;
    job.budget.strip_rows = all ? job.view.height : step;
  } else if (job.budget.strip_rows % step != 0) {
    return usage(fmt::format("--strip-rows {}: a {} takes multiples of {} rows", job.budget.strip_rows,
                             job.panel->kind->name, step));
  }
  return Done{};
}

Result<Job> parse(const RenderCommandLine& arguments) {
  Job job;
  const Result<PictureSettings> settings = settings_of(arguments.scene);
  if (!settings) return settings.failure();
  const auto panel = parse_panel(arguments.panel, arguments.view.size, arguments.view.format);
  if (!panel) return panel.failure();
  job.panel = *panel;
  const Result<View> view = job.panel ? parse_quality(arguments.view, *settings, panel_view(*job.panel))
                                      : parse_view(arguments.view, *settings);
  if (!view) return view.failure();
  job.view = *view;
  job.edges = parse_edges(arguments.view, *settings);
  const Result<DepthFormat> depth_format = parse_depth_format(arguments.depth_format, *settings);
  if (!depth_format) return depth_format.failure();
  job.depth_format = *depth_format;
  job.depth_given = depth_option(arguments.depth_format);
  if (arguments.camera.orthographic && !effects_agree(depth_effect(*depth_format) | effect::orthographic)) {
    return usage("--depth-format float and w16 need a perspective camera, not --ortho");
  }
  if (arguments.perspective) {
    const Result<Effects> perspective = parse_perspective(*arguments.perspective);
    if (!perspective) return perspective.failure();
    job.perspective = *perspective;
  } else {
    job.perspective = settings->perspective.value_or(Effects{});
  }
  const Result<Done> memory =
      parse_memory({.ram = arguments.ram, .strip_rows = arguments.strip_rows, .strip_columns = arguments.strip_columns},
                   *settings, job.view, job.budget);
  if (!memory) return memory.failure();
  if (job.panel) {
    if (const Result<Done> fitted = fit_strips_to_panel(job); !fitted) return fitted.failure();
  }
  job.threads =
      arguments.threads ? *arguments.threads : std::clamp(std::thread::hardware_concurrency(), 1U, kMaxThreads);
  std::optional<ImageType> type;
  if (arguments.image) {
    const Result<ImageType> parsed = parse_image_type(*arguments.image);
    if (!parsed) return parsed.failure();
    type = *parsed;
  }
  const Result<VisibilityRequest> visibility = parse_visibility(arguments.visibility, settings->visibility);
  if (!visibility) return visibility.failure();
  job.visibility = *visibility;
  const Result<Done> checked = check_visibility(job.effects() | job.visibility.method, job.depth_given);
  if (!checked) return checked.failure();
  if (job.visibility.show != Show::colour && job.panel) {
    return usage("--show and --panel exclude each other: a panel shows colours");
  }
  if (job.visibility.show != Show::colour && job.view.format != PixelFormat::rgb565) {
    return usage("--show makes RGB565 pictures; leave out --format");
  }
  if (job.visibility.show != Show::colour && job.view.samples != 1) {
    return usage("--show shows pixels of one sample; use --samples 1");
  }
  if (job.visibility.show != Show::colour && arguments.view.edges.value_or(false)) {
    return usage("--show shows pixels as they were drawn; leave out --edges");
  }
  const Result<ModelOptions> model = parse_model(arguments.camera, arguments.scene);
  if (!model) return model.failure();
  job.model = *model;
  const Result<CameraOptions> camera = parse_camera(arguments.camera, arguments.scene);
  if (!camera) return camera.failure();
  job.camera = *camera;
  Result<OutputNames> outputs = name_outputs(arguments.scene, arguments.output, arguments.frames, type,
                                             shown_format(job), settings->frames.value_or(kFolderFrames));
  if (!outputs) return outputs.failure();
  const bool built_in = kind_of_scene(arguments.scene) == SceneKind::built_in;
  const std::optional<std::string> sets =
      job.visibility.sets.empty() ? std::nullopt : std::optional(job.visibility.sets);
  const Result<Done> distinct = check_distinct(*outputs, arguments.json, built_in ? "" : arguments.scene, sets);
  if (!distinct) return distinct.failure();
  job.outputs = std::move(*outputs);
  return job;
}

/// Why nothing of the scene is seen, or next to nothing of a model; empty: it is seen.
std::string words_of_emptiness(Stage& stage, const Job& job, const RunRecord& run) {
  const std::string too_small = job.camera.placed() ? "" : why_too_small(stage, job.view);
  const bool drawn =
      std::ranges::any_of(run.frames, [](const FrameRecord& frame) { return frame.report.statistics.fragments > 0; });
  if (!too_small.empty()) return (drawn ? "most of the model is not seen: " : "no pixel was drawn: ") + too_small;
  if (!drawn) {
    return fmt::format("no pixel was drawn: the camera does not see the scene; check --eye, --orbit, --look-at{}",
                       kind_of_scene(run.scene) == SceneKind::model ? ", --up" : "");
  }
  const std::uint32_t first = run.frames.front().report.crc32;
  const bool all_alike =
      std::ranges::all_of(run.frames, [first](const FrameRecord& frame) { return frame.report.crc32 == first; });
  if (!all_alike || job.visibility.show != Show::colour || !is_background(stage, job.view, first)) return {};
  return "nothing is seen in the picture: " + why_unseen(stage);
}

/// An empty picture looks like a mistake of the renderer.
void warn_if_empty(Stage& stage, const Job& job, RunRecord& run) {
  std::string warning = words_of_emptiness(stage, job, run);
  if (warning.empty()) return;
  print_warning(warning);
  run.warnings.push_back(std::move(warning));
}

/// What the real panel might not take, the bus's clock above all.
void warn_of_complaints(const PanelModel& panel, RunRecord& run) {
  for (const std::string& complaint : panel.complaints()) {
    run.warnings.push_back("the panel may not do this: " + complaint);
    print_warning(run.warnings.back());
  }
}

std::optional<PanelRecord> panel_record(const Job& job) {
  if (!job.panel) return std::nullopt;
  return PanelRecord{job.panel->kind->name, bus_words(*job.panel),
                     90 * static_cast<int>(job.panel->orientation.rotation), job.panel->orientation.mirrored};
}

/// Of all frames: the scene's animation, or else a turn, which has no time of its own.
std::uint32_t milliseconds_of(const Stage& stage) {
  constexpr std::uint32_t kTurn = 4000;
  for (const Animation& animation : {stage.animation(), stage.joint_animation()}) {
    if (!animation.tracks.empty()) return animation.duration;
  }
  return kTurn;
}

/// What a thread has for itself: a stage to place, a renderer with its memory.
struct Worker {
  std::unique_ptr<Stage> stage;
  FrameRenderer renderer;
  const VisibleSetFile* sets;             // or none
  std::unique_ptr<SimulatedPanel> panel;  // or none
};

Result<std::unique_ptr<SimulatedPanel>> start_panel(const PanelRequest& request) {
  std::unique_ptr<SimulatedPanel> panel = open_panel(request);
  if (const hal::Error error = panel->start(); error != hal::Error::none) {
    return Failure{ExitStatus::internal, fmt::format("the panel does not start: {}", hal::message(error))};
  }
  return panel;
}

/// The bytes of a file.
using Picture = std::vector<std::uint8_t>;

/// What the strips are, or what is seen on the panel.
Result<Picture> encode_picture(const Worker& worker, const Job& job, std::span<const std::byte> pixels) {
  if (!worker.panel) return encode(job.outputs.type, job.view, pixels);
  if (const std::string dark = worker.panel->model().darkness(); !dark.empty()) {
    return Failure{ExitStatus::internal, "the panel shows nothing: " + dark};
  }
  return encode(job.outputs.type, worker.panel->model().seen());
}

/// `kept`: of an animation's frames, which become a file together.
Result<FrameRecord> render_frame(Worker& worker, const Job& job, std::uint32_t frame, std::vector<Picture>& kept) {
  const Result<Staging> staging = worker.stage->place(frame, job.outputs.frames);
  if (!staging) return staging.failure();
  const Result<Done> checked = check_visibility(
      effects_of(staging->scene, staging->camera) | effects_of(job.view) | job.effects() | job.visibility.method,
      job.depth_given);
  if (!checked) return checked.failure();
  const auto bus_use = [&worker] {
    return worker.panel ? BusUse{worker.panel->bus().bytes(), worker.panel->bus().busy().count()} : BusUse{};
  };
  VisibilityOptions visibility = job.visibility.options;
  if (worker.sets != nullptr) {
    const auto visible = worker.sets->at(staging->scene, staging->camera, worker.stage->animation());
    if (!visible) return visible.failure();
    visibility.potentially_visible = *visible;
  }
  worker.renderer.set_visibility(job.visibility.method, visibility, job.visibility.temporal);
  const BusUse before = bus_use();
  const Result<FrameReport> report = worker.renderer.render(*staging);
  if (!report) return report.failure();
  const BusUse after = bus_use();
  std::span<const std::byte> pixels = worker.renderer.pixels();
  std::optional<Result<ShownFrame>> shown;
  if (job.visibility.show != Show::colour) {
    const MethodRequest request{job.view, job.budget, job.effects() | job.visibility.method, visibility};
    shown = draw_shown(*staging, request, job.visibility.show);
    if (!*shown) return shown->failure();
    pixels = std::as_bytes(std::span((*shown)->pixels));
  }
  Result<Picture> picture = encode_picture(worker, job, pixels);
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
  FrameRecord record{file.string(), *report, {after.bytes - before.bytes, after.nanoseconds - before.nanoseconds}, {}};
  if (shown) record.report.crc32 = checksum(pixels);
  if (job.visibility.show == Show::error) record.wrong = (*shown)->wrong;
  return record;
}

/// Several frames are drawn, encoded and written on all threads, one frame on each; the strips of a single frame are.
Result<RunRecord> render_frames(const std::string& scene, const Job& job, bool quiet) {
  Result<std::unique_ptr<Stage>> stage = open_stage(scene, job.model, job.camera, job.view, job.outputs.frames);
  const bool shows_colours = job.visibility.show == Show::colour;
  if (stage && !shows_colours) {
    const Result<Staging> staging = (*stage)->place(0, job.outputs.frames);
    if (staging && (job.edges.value_or(false) || !staging->scene.edges.empty())) {
      print_warning("--show shows pixels as they were drawn: edges are not smoothed");
    }
  }
  if (stage) stage = with_edges(std::move(*stage), shows_colours ? job.edges : false, job.view);
  if (!stage) return stage.failure();
  for (const std::string& warning : (*stage)->warnings()) print_warning(warning);
  // What is wrong is judged by the scene itself.
  if (job.outputs.frames > 1 && job.visibility.method.has(method::bsp) && job.visibility.show != Show::error) {
    stage = with_tree(std::move(*stage), job.outputs.frames);
    if (!stage) return stage.failure();
  }
  RunRecord run{scene, job.view, (*stage)->warnings(), std::vector<FrameRecord>(job.outputs.frames), panel_record(job)};

  std::optional<VisibleSetFile> sets;
  if (!job.visibility.sets.empty()) {
    Result<VisibleSetFile> read = VisibleSetFile::read(job.visibility.sets);
    if (!read) return read.failure();
    sets = std::move(*read);
  }
  // Each frame begins with what the one before has seen.
  const unsigned threads = job.visibility.temporal ? 1 : std::min(job.threads, job.outputs.frames);
  const unsigned strip_threads = job.outputs.frames == 1 ? job.threads : 1;
  std::vector<Worker> workers;
  for (unsigned thread = 0; thread < threads; ++thread) {
    workers.push_back({(*stage)->copy(), FrameRenderer(job.view, job.budget, job.effects(), strip_threads),
                       sets ? &*sets : nullptr, nullptr});
    if (!job.panel) continue;
    Result<std::unique_ptr<SimulatedPanel>> panel = start_panel(*job.panel);
    if (!panel) return panel.failure();
    workers.back().panel = std::move(*panel);
    workers.back().renderer.show_on(*workers.back().panel);
  }
  Progress progress(job.outputs.frames, !quiet);
  std::mutex mutex;  // of the progress
  std::uint32_t done = 0;
  std::vector<Picture> kept(job.outputs.is_animated() ? job.outputs.frames : 0);
  const auto draw = [&](unsigned thread, std::uint32_t frame) {
    Result<FrameRecord> record = render_frame(workers[thread], job, frame, kept);
    if (!record) return Result<Done>(record.failure());
    run.frames[frame] = std::move(*record);
    const std::scoped_lock lock(mutex);
    progress.show(++done);
    return Result<Done>(Done{});
  };
  // The first one makes the folder, once it is known that the scene can be drawn.
  if (const Result<Done> first = draw(0, 0); !first) return first.failure();
  const Result<Done> others = for_each_on_threads(
      job.outputs.frames - 1, threads, [&](unsigned thread, std::uint32_t index) { return draw(thread, index + 1); });
  if (!others) return others.failure();
  if (job.outputs.is_animated()) {
    const Picture animation = animated_png(kept, milliseconds_of(**stage));
    if (const Result<Done> written = write_file(job.outputs.path, animation, "-o"); !written) return written.failure();
  }
  // All workers' panels are alike.
  if (workers.front().panel) warn_of_complaints(workers.front().panel->model(), run);
  warn_if_empty(**stage, job, run);
  return run;
}

Result<Done> report(const RunRecord& run, const RenderCommandLine& arguments) {
  const bool json_on_stdout = arguments.json && (*arguments.json == "-" || is_standard_output(*arguments.json));
  if (arguments.json) {
    const std::string json = to_json(run);
    if (json_on_stdout) {
      write_text(stdout, json);  // main looks at the stream's state
    } else if (const Result<Done> written = write_file(
                   *arguments.json, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}, "--json");
               !written) {
      return written.failure();
    }
  }
  if (arguments.quiet) return Done{};
  const bool stdout_taken = json_on_stdout || (arguments.output && is_standard_output(*arguments.output));
  if (!write_text(stdout_taken ? stderr : stdout, summary(run)) && stdout_taken) {
    return Failure{ExitStatus::output, "cannot write the summary to standard error; is the disk full?"};
  }
  return Done{};
}

int run_render(const RenderCommandLine& arguments) {
  const Result<Job> job = parse(arguments);
  if (!job) return print_failure(job.failure());
  Result<RunRecord> record = render_frames(arguments.scene, *job, arguments.quiet);
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
  command
      ->add_option("scene", a.scene,
                   "A built-in scene, a model (.obj .gltf .glb .stl .ply .3ds .dae ...), a scene file (.toml) or a "
                   "baked scene (.zsc)")
      ->required()
      ->type_name("SCENE");
  command
      ->add_option("-o,--output", a.output,
                   "A folder for the frames, or one file: .png .jpg .ppm .pgm .raw, .apng with all "
                   "frames (default: SCENE.png here)")
      ->type_name("DIR|FILE");
  command
      ->add_option(
          "--size", a.view.size,
          "Size of the picture, each side 1 to 4096 (default: 320x240, the panel's, or what the scene was baked for)")
      ->type_name("WxH");
  command
      ->add_option(
          "--frames", a.frames,
          "Frames of the animation, or of a full turn, 1 to 10000 (default: 1 into a picture, 8 into a folder or "
          ".apng)")
      ->option_text("N")
      ->check(CLI::Range(1U, kMaxFrames));
  command->add_option("--threads", a.threads, "Threads that draw, the same pixels with any (default: one a core)")
      ->option_text("N")
      ->check(CLI::Range(1U, kMaxThreads));
  command->add_option("--ram", a.ram, "Renderer's memory at most, K and M allowed (default: no limit)")
      ->type_name("BYTES");
  command->add_option("--strip-rows", a.strip_rows, "Rows of a strip (default: auto, as many as fit)")
      ->type_name("N|auto");
  command
      ->add_option("--strip-columns", a.strip_columns,
                   "Pixels of a strip's row, a multiple of 8 (default: auto, the picture's width)")
      ->type_name("N|auto");
  command
      ->add_option("--format", a.view.format,
                   "Pixels: rgb565 (default), rgb565_swapped, gray4, mono, rgb666, rgb444, xrgb8888")
      ->type_name("FORMAT");
  add_quality_options(*command, a.view);
  command
      ->add_option("--depth-format", a.depth_format,
                   "Depth in the z-buffer: z16 (default), float, w16, z24 or z32; the last three for comparison")
      ->type_name("FORMAT");
  command
      ->add_option(
          "--perspective", a.perspective,
          "Textures are exact at every pixel (1), every 8th or 16th of a row (16 is the default), or only at a "
          "triangle's corners (affine)")
      ->type_name("RUN");
  command->add_option("--image", a.image, "Picture files: png (default), jpeg, ppm or raw")->type_name("TYPE");
  add_panel_options(*command, a.panel);
  add_camera_options(*command, a.camera);
  add_visibility_options(*command, a.visibility);
  command->add_option("--json", a.json, "Write a report of each frame; - is standard output")->type_name("FILE|-");
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
      "  zstrip render teapot -o oled.png --panel ssd1306 --bus i2c@400kHz --dither\n"
      "  zstrip render teapot -o smooth.png --samples 4");
  command->callback([arguments, &exit_code] { exit_code = run_render(*arguments); });
}

}  // namespace zstrip::sim
