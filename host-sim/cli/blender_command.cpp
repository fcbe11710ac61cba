// `zstrip blender`: writes the add-on for Blender as the zip file that Blender installs.
#include "cli/blender_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "blender/add_on_texts.hpp"
#include "blender/zip_file.hpp"
#include "cli/print.hpp"
#include "image/write_file.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

struct BlenderArguments {
  std::string output = "zstrip_blender.zip";
  bool quiet = false;
};

Result<Done> run_blender(const BlenderArguments& arguments) {
  if (lower(std::filesystem::path(arguments.output).extension().string()) != ".zip") {
    return Failure{ExitStatus::usage,
                   fmt::format("-o '{}' must end in .zip, which Blender installs", arguments.output)};
  }
  const std::vector<std::uint8_t> zip = to_zip(kAddOnFiles);
  if (const Result<Done> written = write_file(arguments.output, zip, "-o"); !written) return written.failure();
  if (!arguments.quiet) {
    write_text(stdout,
               fmt::format("{}: {}; in Blender: Edit, Preferences, Add-ons, Install\n", printable(arguments.output),
                           counted(zip.size(), "byte")));  // main checks the stream's state
  }
  return Done{};
}

}  // namespace

void add_blender_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("blender", "Write the add-on that shows a device's pixels in Blender");
  const auto arguments = std::make_shared<BlenderArguments>();
  command->add_option("-o,--output", arguments->output, "The zip file to write")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_flag("--quiet", arguments->quiet, "No report; errors remain");
  command->footer("Examples:\n  zstrip blender\n  zstrip blender -o zstrip_blender.zip");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run_blender(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
