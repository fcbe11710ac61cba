// The options that say what a picture is and what memory it may take, shared by the commands that plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "plan/alternatives.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// As given on the command line.
struct PlanArguments {
  std::string size = "320x240";
  std::string format = "rgb565";
  std::optional<std::string> ram{};
  std::string strip_rows = "auto";
  std::string strip_columns = "auto";
  bool split_columns = false;
  std::uint32_t strip_buffers = 1;
  std::string mode = "any";
};

/// Adds the options; `arguments` must live as long as the command.
void add_plan_options(CLI::App& command, PlanArguments& arguments);

Result<PlanRequest> parse_plan(const PlanArguments& arguments);

}  // namespace zstrip::sim
