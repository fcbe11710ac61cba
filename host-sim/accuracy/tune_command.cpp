// Options of `zstrip tune`.
#include "accuracy/tune_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>
#include <tuple>

#include "accuracy/tune.hpp"
#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "cli/print.hpp"
#include "cli/sibling_program.hpp"
#include "image/write_file.hpp"
#include "text/number.hpp"
#include "text/progress.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string scene;
  std::string target = "host";
  std::string size = "320x240";
  std::optional<std::string> up;
  std::string format = "rgb565";
  std::optional<std::string> error_pixels, ram, flash;
  std::optional<double> perceived, fps;
  std::uint32_t frames = 1;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool programs = false;
  bool quiet = false;
  std::string firmware;
  std::optional<std::string> output;
};

/// Parses "0.5%" or "0.5".
Result<double> parse_percent(const std::string& text) {
  const std::string_view digits = text.ends_with('%') ? std::string_view(text).substr(0, text.size() - 1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || !(value >= 0) || value > 100) {
    return Failure{ExitStatus::usage, fmt::format("--max-error-pixels '{}' must be a percentage, such as 0.5%", text)};
  }
  return value;
}

Result<Limits> parse_limits(const Arguments& arguments) {
  Limits limits{.perceived = arguments.perceived, .frames = arguments.fps};
  if (limits.frames && !(*limits.frames > 0)) {
    return Failure{ExitStatus::usage, fmt::format("--min-fps {} must be more than 0", *limits.frames)};
  }
  if (limits.perceived && !(*limits.perceived >= 0)) {
    return Failure{ExitStatus::usage, fmt::format("--max-perceived {} must be 0 or more", *limits.perceived)};
  }
  if (arguments.error_pixels) {
    const Result<double> percent = parse_percent(*arguments.error_pixels);
    if (!percent) return percent.failure();
    limits.wrong_pixels = *percent;
  }
  for (const auto& [option, text, limit] : {std::tuple{"--max-ram", &arguments.ram, &limits.ram},
                                            std::tuple{"--max-flash", &arguments.flash, &limits.flash}}) {
    if (!*text) continue;
    const Result<std::uint32_t> bytes = parse_bytes(**text, option);
    if (!bytes) return bytes.failure();
    *limit = *bytes;
  }
  return limits;
}

std::string report(const Tuned& tuned) {
  const AccuracyPoint& point = *tuned.best;
  std::string text =
      fmt::format("{} settings looked at, {} timed; the cheapest within the limits:\n", tuned.candidates, tuned.timed);
  for (const KnobInfo& knob : knobs()) {
    const KnobValue& value = knob.values[point.settings[knob.knob]];
    text += fmt::format("  {:<12} {:<8} {}\n", knob.name, value.name, value.meaning);
  }
  text += fmt::format("wrong pixels {:.3g} %, visible error {:.3g}, RAM {} bytes, scene {} bytes",
                      point.errors[Figure::wrong_pixels], point.errors[Figure::perceived],
                      grouped(point.cost.ram_bytes), grouped(point.cost.scene_bytes));
  if (point.cost.instructions) text += fmt::format(", {} instructions a frame", grouped(*point.cost.instructions));
  if (const std::optional<double> fps = frames_per_second(point)) text += fmt::format(", {:.3g} frames a second", *fps);
  return text + "\n";
}

Result<Done> run(const Arguments& arguments) {
  const auto size = parse_size(arguments.size);
  if (!size) return size.failure();
  const Result<std::optional<UpAxis>> up = parse_up_axis(arguments.up);
  if (!up) return up.failure();
  const Result<Limits> limits = parse_limits(arguments);
  if (!limits) return limits.failure();
  const AccuracyRequest request{.scene = arguments.scene,
                                .view = {size->first, size->second, PixelFormat::rgb565},
                                .up = *up,
                                .frames = arguments.frames,
                                .target = arguments.target,
                                .firmware = arguments.firmware};
  const auto scene = AccuracyScene::open(request);
  if (!scene) return scene.failure();
  if (arguments.programs) {
    const Result<std::vector<std::string>> programs = programs_to_tune(**scene, *limits, arguments.format);
    if (!programs) return programs.failure();
    std::string names;
    for (const std::string& name : *programs) names += name + "\n";
    write_text(stdout, names);
    return Done{};
  }
  Result<Tuned> tuned = [&] {
    Progress progress(1, !arguments.quiet, "point");
    return tune(**scene, *limits, arguments.format, arguments.jobs, [&](std::size_t done, std::size_t all) {
      progress.show(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(all));
    });
  }();
  if (!tuned) return tuned.failure();
  if (!tuned->best) {
    std::string why;
    for (const std::string& line : tuned->broken) why += fmt::format("{}{}", why.empty() ? "" : "; ", line);
    return Failure{ExitStatus::budget, fmt::format("no settings keep all limits: {}", why)};
  }
  if (!arguments.quiet) write_text(stdout, report(*tuned));
  if (!arguments.output) {
    write_text(stdout, quality_toml(*tuned->best));
    return Done{};
  }
  const fs::path folder = *arguments.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    return Failure{ExitStatus::output, fmt::format("the folder '{}' cannot be made ({}); name another with -o",
                                                   folder.string(), error.message())};
  }
  for (const auto& [name, text] :
       {std::pair{"quality.toml", quality_toml(*tuned->best)}, std::pair{"quality.json", quality_json(*tuned->best)},
        std::pair{"quality.hpp", quality_header(*tuned->best, request.view)}}) {
    const Result<Done> written =
        write_file(folder / name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "-o");
    if (!written) return written.failure();
  }
  return Done{};
}

}  // namespace

void add_tune_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(kTuneCommand.name, kTuneCommand.description);
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("scene", a.scene, "A built-in scene, a scene file, a model or a baked scene")
      ->required()
      ->type_name("SCENE");
  command->add_option("--target", a.target, "The target that is timed: host, or an emulated m0, m3 or m4f")
      ->transform(one_of({"host", "m0", "m3", "m4f"}))
      ->capture_default_str();
  command->add_option("--size", a.size, "Size of the picture")
      ->transform(lower_case())
      ->type_name("WxH")
      ->capture_default_str();
  command->add_option("--format", a.format, "Pixels of the display: rgb565, gray4 or mono")
      ->transform(lower_case())
      ->type_name("FORMAT")
      ->capture_default_str();
  command
      ->add_option("--max-error-pixels", a.error_pixels, "Pixels with a wrong surface or silhouette, of those covered")
      ->type_name("PERCENT");
  command
      ->add_option("--max-perceived", a.perceived, "Mean visible difference to the truth, CIELAB; 1 is just noticeable")
      ->type_name("N");
  command->add_option("--max-ram", a.ram, "Arena and one strip of pixels, K and M allowed")->type_name("BYTES");
  command->add_option("--max-flash", a.flash, "The scene, K and M allowed")->type_name("BYTES");
  command->add_option("--min-fps", a.fps, "The fewest frames a second; on boards by the lower end of the prediction")
      ->type_name("N");
  command->add_option("--frames", a.frames, "Poses of a full rotation")
      ->type_name("N")
      ->check(CLI::Range(1U, 60U))
      ->capture_default_str();
  command->add_option("--jobs", a.jobs, "Settings measured at once (default: one a core)")
      ->type_name("N")
      ->check(CLI::Range(1U, 256U));
  command->add_option("--up", a.up, "Axis that points upwards in a model file (default: as its format says)")
      ->transform(lower_case())
      ->type_name("AXIS");
  command->add_option("--firmware", a.firmware, "Folder of the boards' programs (default: where the build puts them)")
      ->type_name("DIR");
  command
      ->add_option("-o,--output", a.output,
                   "Folder for quality.toml, quality.json and quality.hpp (default: the first, on standard output)")
      ->type_name("DIR");
  command->add_flag("--list-programs", a.programs, "Print the names of the boards' programs that may be run, and end");
  command->add_flag("--quiet", a.quiet, "No report and no progress");
  command->footer(
      "Exit status 5 if no settings keep all limits; the message says which and by how much.\nExamples:\n"
      "  zstrip tune knot --max-error-pixels 0.5% --max-ram 16K\n"
      "  zstrip tune knot --target m3 --size 240x240 --max-error-pixels 0.5% --max-ram 16K --min-fps 30 -o "
      "out/quality");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
