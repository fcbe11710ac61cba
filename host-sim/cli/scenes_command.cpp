// `zstrip scenes`: lists the built-in scenes.
#include "cli/scenes_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <span>
#include <string>

#include "result.hpp"
#include "text/number.hpp"
#include "text/text.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::sim {

void add_scenes_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  command->footer("Example:\n  zstrip scenes");
  command->callback([&exit_code] {
    std::string list = fmt::format("{:<18} {:>9} {:>9}  {}\n", "name", "triangles", "vertices", "description");
    for (const std::span<const scenes::BuiltIn> part : {scenes::built_in(), scenes::effect_scenes()}) {
      for (const scenes::BuiltIn& scene : part) {
        list += fmt::format("{:<18} {:>9} {:>9}  {}\n", scene.name, grouped(scene.counts.triangles),
                            grouped(scene.counts.vertices), scene.description);
      }
    }
    write_text(stdout, list);  // main checks the stream's state
    exit_code = static_cast<int>(ExitStatus::ok);
  });
}

}  // namespace zstrip::sim
