// Options of `zstrip accuracy`, and the order of its work: truth, points, front, files.
#include "accuracy/accuracy_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "accuracy/board_cost.hpp"
#include "accuracy/campaign.hpp"
#include "accuracy/causes.hpp"
#include "accuracy/page.hpp"
#include "accuracy/plot.hpp"
#include "accuracy/recorded.hpp"
#include "accuracy/results.hpp"
#include "accuracy/tables.hpp"
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
  std::vector<std::string> scenes;
  std::vector<std::string> targets{"host"};
  std::vector<std::string> default_targets;
  std::string knobs = "all";
  std::string size = "160x120";
  std::optional<std::string> up;
  std::vector<std::string> only;
  std::uint32_t frames = 2;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  bool singles = false;
  bool presets = false;
  bool programs = false;
  bool quiet = false;
  std::string firmware;
  std::string recorded;
  std::string output = "accuracy";
};

struct Job {
  struct Target {
    std::string name;
    CampaignOptions options;
  };
  std::vector<AccuracyRequest> requests;  ///< one for each scene, for the first target
  std::vector<Target> targets;
};

Result<Job> parse(const Arguments& arguments) {
  const auto size = parse_size(arguments.size);
  if (!size) return size.failure();
  const Result<std::optional<UpAxis>> up = parse_up_axis(arguments.up);
  if (!up) return up.failure();
  const Result<std::vector<Knob>> turned = parse_knobs(arguments.knobs);
  if (!turned) return turned.failure();
  CampaignOptions options{.knobs = *turned,
                          .only = {},
                          .jobs = arguments.jobs,
                          .product = !arguments.singles,
                          .presets = arguments.presets};
  for (const std::string& text : arguments.only) {
    const Result<Settings> settings = parse_settings(text);
    if (!settings) return settings.failure();
    options.only.push_back(*settings);
  }
  Job job;
  for (const std::string& target : arguments.targets) job.targets.push_back({target, options});
  options.only = {Settings{}};
  for (const std::string& target : arguments.default_targets) job.targets.push_back({target, options});
  for (const std::string& scene : arguments.scenes) {
    job.requests.push_back({.scene = scene,
                            .view = {size->first, size->second, PixelFormat::rgb565},
                            .up = *up,
                            .frames = arguments.frames,
                            .target = arguments.targets.front(),
                            .firmware = arguments.firmware});
  }
  return job;
}

Result<Done> write(const fs::path& path, const std::string& text) {
  return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "-o");
}

std::string file_name(const AccuracyRequest& request) {
  return fmt::format("{}_{}.svg", scene_name(request), request.target);
}

std::string summary(const Campaign& campaign, double seconds) {
  const AccuracyPoint* best = recommended(campaign);
  std::size_t front = 0;
  for (const AccuracyPoint& point : campaign.points) front += point.on_front ? 1 : 0;
  std::string text =
      fmt::format("{} on {}: {} points, {} measured now in {:.0f} s, {} on the front\n", campaign.request.scene,
                  campaign.request.target, campaign.points.size(), campaign.measured, seconds, front);
  if (best != nullptr) text += fmt::format("  recommended: {}\n", to_text(best->settings));
  return text;
}

/// Opens the scene in a small picture, for facts that do not depend on the picture's size: if it can be drawn, its
/// effects.
Result<std::unique_ptr<AccuracyScene>> open_small(AccuracyRequest request) {
  request.view = {16, 12, PixelFormat::rgb565};
  request.frames = 1;
  return AccuracyScene::open(request);
}

/// Lists the boards' programs that the job needs, one name a line; host-sim/run builds them.
Result<Done> list_programs(const Job& job) {
  std::set<std::string> names;
  for (const AccuracyRequest& request : job.requests) {
    const auto scene = open_small(request);
    if (!scene) return scene.failure();
    for (const auto& [target, options] : job.targets) {
      if (const Result<Done> checked = check_settings(**scene, options); !checked) return checked.failure();
      std::vector<Settings> settings = first_settings(**scene, options);
      if (options.product && options.only.empty()) {
        const std::vector<Settings> all = all_settings(**scene, options.knobs);
        settings.insert(settings.end(), all.begin(), all.end());
      }
      if (target == "host") continue;
      for (const std::string& name : programs_for((*scene)->on(target), settings)) names.insert(name);
    }
  }
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  write_text(stdout, text);
  return Done{};
}

/// Measures one scene on one target, and writes its plot at once.
Result<Done> measure(const AccuracyScene& scene, const CampaignOptions& options, const std::vector<CauseErrors>& causes,
                     bool quiet, const fs::path& folder, Journal& journal, std::vector<Campaign>& campaigns,
                     std::vector<PageScene>& pages) {
  const auto start = std::chrono::steady_clock::now();
  Result<Campaign> campaign = [&] {
    Progress progress(1, !quiet, "point");
    return run_campaign(scene, options, journal, [&](std::size_t done, std::size_t all) {
      progress.show(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(all));
    });
  }();
  if (!campaign) return campaign.failure();
  campaign->causes = causes;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (!quiet) write_text(stdout, summary(*campaign, took.count()));
  if (const Result<Done> written = write(folder / file_name(scene.request()), plot_file_svg(*campaign)); !written)
    return written.failure();
  Result<PageScene> page = with_pictures(scene, *campaign, options.jobs);
  if (!page) return page.failure();
  pages.push_back(std::move(*page));
  campaigns.push_back(std::move(*campaign));
  return Done{};
}

Result<Done> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return Done{};
  return Failure{ExitStatus::output, fmt::format("the folder '{}' cannot be made ({}); name another with -o",
                                                 folder.string(), error.message())};
}

/// Writes tables and plots from recorded figures, accuracy.csv and accuracy-causes.csv.
Result<Done> retabulate(const fs::path& recorded, const fs::path& folder) {
  const Result<RecordedTable> settings = RecordedTable::read(recorded / "accuracy.csv", {"scene", "settings"});
  if (!settings) return settings.failure();
  const Result<RecordedTable> causes =
      RecordedTable::read(recorded / "accuracy-causes.csv", {"scene", "cause", "settings"});
  if (!causes) return causes.failure();
  const Result<std::vector<Campaign>> campaigns = recorded_campaigns(*settings);
  if (!campaigns) return campaigns.failure();
  if (const Result<Done> made = make_folder(folder); !made) return made.failure();
  for (const Campaign& campaign : *campaigns) {
    const fs::path plot = folder / fmt::format("accuracy-{}.svg", scene_name(campaign.request));
    if (const Result<Done> written = write(plot, plot_file_svg(campaign)); !written) return written.failure();
  }
  try {
    return write(folder / "accuracy.md", accuracy_tables(*settings, *causes));
  } catch (const std::logic_error& error) {  // thrown by std::stod
    return Failure{ExitStatus::input, fmt::format("'{}' or '{}' has a field that is not a number ({})",
                                                  settings->file(), causes->file(), error.what())};
  }
}

Result<Done> run(const Arguments& arguments) {
  if (!arguments.recorded.empty()) return retabulate(arguments.recorded, arguments.output);
  if (arguments.scenes.empty())
    return Failure{ExitStatus::usage, "name a scene: zstrip accuracy knot -o out/accuracy; 'zstrip scenes' lists them"};
  const Result<Job> job = parse(arguments);
  if (!job) return job.failure();
  if (arguments.programs) return list_programs(*job);
  for (const AccuracyRequest& request : job->requests) {
    if (const auto scene = open_small(request); !scene) return scene.failure();  // no files are left behind
  }
  const fs::path folder = arguments.output;
  if (const Result<Done> made = make_folder(folder); !made) return made.failure();
  Result<Journal> journal = Journal::open(folder / "points.jsonl");
  if (!journal) return journal.failure();
  std::vector<Campaign> campaigns;
  std::vector<PageScene> pages;
  for (const AccuracyRequest& request : job->requests) {
    const auto scene = AccuracyScene::open(request);
    if (!scene) return scene.failure();
    const CampaignOptions& all = job->targets.front().options;
    Result<std::vector<CauseErrors>> causes = std::vector<CauseErrors>{};
    if (all.only.empty()) causes = errors_of(**scene, cause_cases(**scene, all.knobs), all.jobs);
    if (!causes) return causes.failure();
    for (const auto& [target, options] : job->targets) {
      const Result<Done> measured =
          measure((*scene)->on(target), options, *causes, arguments.quiet, folder, *journal, campaigns, pages);
      if (!measured) return measured.failure();
    }
  }
  for (const auto& [name, text] :
       {std::pair{"accuracy.csv", accuracy_csv(campaigns)}, std::pair{"causes.csv", causes_csv(campaigns)},
        std::pair{"accuracy.json", accuracy_json(campaigns)}, std::pair{"index.html", accuracy_page(pages)}}) {
    if (const Result<Done> written = write(folder / name, text); !written) return written.failure();
  }
  if (!arguments.quiet) write_text(stdout, fmt::format("{} shows them all\n", (folder / "index.html").string()));
  return Done{};
}

std::string footer() {
  std::string text = "Knobs, the default first:\n";
  for (const KnobInfo& knob : knobs()) {
    std::string values;
    for (const KnobValue& value : knob.values) values += fmt::format("{}{}", values.empty() ? "" : ", ", value.name);
    text += fmt::format("  {:<12} {}: {}\n", knob.name, knob.meaning, values);
  }
  return text +
         "Examples:\n"
         "  zstrip accuracy knot -o out/accuracy\n"
         "  zstrip accuracy knot room --target m3 --knobs depth,fit,strips -o out/m3\n"
         "  zstrip accuracy teapot --only depth=float,detail=50 --only exact -o out/two\n"
         "An interrupted run continues where it ended: its points are in points.jsonl in the folder.";
}

}  // namespace

void add_accuracy_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(kAccuracyCommand.name, kAccuracyCommand.description);
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("scenes", a.scenes, "Built-in scenes, scene files, models or baked scenes")
      ->type_name("SCENE...");
  command
      ->add_option("--target", a.targets,
                   "Targets that are timed, separated by commas: host, or an emulated m0, m3 or m4f")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(one_of({"host", "m0", "m3", "m4f"}))
      ->capture_default_str();
  command->add_option("--default-on", a.default_targets, "Targets on which only the default is measured")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(one_of({"host", "m0", "m3", "m4f"}));
  command->add_option("--knobs", a.knobs, "Knobs to vary, separated by commas, or all")
      ->transform(lower_case())
      ->capture_default_str();
  command->add_option("--size", a.size, "Size of the picture")
      ->transform(lower_case())
      ->type_name("WxH")
      ->capture_default_str();
  command->add_option("--frames", a.frames, "Poses of a full rotation")
      ->type_name("N")
      ->check(CLI::Range(1U, 60U))
      ->capture_default_str();
  command->add_option("--jobs", a.jobs, "Points measured at once (default: one a core)")
      ->type_name("N")
      ->check(CLI::Range(1U, 256U));
  command->add_option("--only", a.only, "These settings and no others, as KNOB=VALUE,... or a preset's name")
      ->transform(lower_case())
      ->type_name("SETTINGS");
  command->add_flag("--singles", a.singles, "One knob at a time, no combinations");
  command->add_flag("--presets", a.presets, "The presets tiny, balanced and exact, too");
  command->add_option("--up", a.up, "Axis that points upwards in a model file (default: as its format says)")
      ->transform(lower_case())
      ->type_name("AXIS");
  command->add_option("--firmware", a.firmware, "Folder of the boards' programs (default: where the build puts them)")
      ->type_name("DIR");
  command->add_flag("--list-programs", a.programs,
                    "Print the names of the boards' programs that would be run, and end");
  command
      ->add_option("--recorded", a.recorded,
                   "Measure nothing: tables and plots of the figures in a folder such as docs/measured")
      ->type_name("DIR");
  command->add_option("-o,--output", a.output, "Folder for page, plots, tables and points")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--quiet", a.quiet, "No summary and no progress");
  command->footer(footer());
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
