// The options of `zstrip bake` for whole folders, and the files that it writes into one.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "bake/project_files.hpp"
#include "cli/plan_arguments.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The options as given on the command line.
struct ProjectArguments {
  std::optional<std::string> project;
  std::optional<std::string> display;
  std::optional<std::string> cores;
};

void add_project_options(CLI::App& command, ProjectArguments& arguments);

/// Fails if one of these options is given, because the output is not a folder.
Result<Done> check_no_project(const ProjectArguments& arguments);

/// `output`: the folder, which gives the project its name. Fails for names that no project may have.
Result<Project> parse_project(const ProjectArguments& arguments, const std::string& output);

/// Sets size and format, where they are not given, to those of the usual panel, and two strip buffers where strips are
/// sent by DMA. For an RGB panel the strips are as high as its bounce buffers.
PlanArguments plan_arguments_for_project(PlanArguments plan, const Project& project);

/// Creates the folder `output`, writes the scene's header into it, and those of the project's other files that are not
/// there yet. An existing file may have its owner's changes: if its content differs, it stays and a warning names it.
Result<Done> write_project(const std::string& output, std::span<const std::uint8_t> header,
                           std::span<const ProjectFile> files);

}  // namespace zstrip::sim
