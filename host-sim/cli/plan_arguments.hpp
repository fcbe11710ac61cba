// The options for the picture and its memory, shared by the commands that plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/picture_arguments.hpp"
#include "plan/alternatives.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct PlanArguments {
  ViewArguments view{};
  MemoryArguments memory{};
  bool split_columns = false;
  std::optional<std::uint32_t> strip_buffers{};
  std::string mode = "any";
  std::optional<std::string> visibility{};
};

/// Adds the options; `arguments` must live as long as the command.
/// `board_help`: more about --board.
void add_plan_options(CLI::App& command, PlanArguments& arguments, const std::string& board_help = {});

/// Settings of the scene, if it is a scene file, apply where the command line has no option.
Result<PlanRequest> parse_plan(const PlanArguments& arguments, const std::string& scene);

}  // namespace zstrip::sim
