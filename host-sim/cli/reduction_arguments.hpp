// The options that make a model smaller, shared by the commands that read one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "import/reduction.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct ReductionArguments {
  std::optional<std::string> texture_size;
  std::optional<std::string> triangles;
  bool lod = false;  ///< for with_levels, of any scene
};

/// Adds --texture-size, --triangles and --lod; `arguments` must live as long as the command.
void add_reduction_options(CLI::App& command, ReductionArguments& arguments);

/// Parses --texture-size and --triangles, which are usage errors unless the scene is a model file.
Result<Reduction> parse_reduction(const ReductionArguments& arguments, const std::string& scene);

}  // namespace zstrip::sim
