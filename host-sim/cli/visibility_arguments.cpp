// The options that say how visibility is found, and what of it is shown.
#include "cli/visibility_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "visibility/methods.hpp"

namespace zstrip::sim {

void add_visibility_options(CLI::App& command, VisibilityArguments& arguments) {
  VisibilityArguments& a = arguments;
  command
      .add_option("--visibility", a.method,
                  fmt::format("How visibility is found: {} (default: zbuffer)", visibility_names()))
      ->type_name("METHOD");
  command
      .add_option("--iterations", a.iterations,
                  fmt::format("Levels of splitting of the midpoint methods, 0 to {} (default: {})", kMostIterations,
                              a.iterations))
      ->option_text("N")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{kMostIterations}));
  command
      .add_option("--sort-key", a.key, "The depth by which triangles are sorted: middle (default), nearest or farthest")
      ->option_text("KEY")
      ->check(CLI::IsMember({"middle", "nearest", "farthest"}));
  command
      .add_option("--cull", a.cull,
                  "What is left out early, separated by commas: back-faces, small, spheres (meshlets by their bounding "
                  "spheres) or none (default: back-faces,small)")
      ->option_text("LIST")
      ->delimiter(',')
      ->check(CLI::IsMember({"back-faces", "small", "spheres", "none"}));
  command
      .add_option("--visible-sets", a.sets,
                  "Leave out the meshlets that cannot be seen from the camera's cell, by a file of zstrip bake")
      ->type_name("FILE");
  command.add_option("--show", a.show, "Instead of the picture: depth, overdraw, tiles or error")->type_name("WHAT");
}

Result<VisibilityRequest> parse_visibility(const VisibilityArguments& arguments,
                                           const std::optional<std::string>& setting) {
  const Result<VisibilityMethod> method = parse_visibility(arguments.method.value_or(setting.value_or("zbuffer")));
  if (!method) return method.failure();
  VisibilityRequest request{.method = method->effects, .options = {}, .sets = arguments.sets};
  request.options.iterations = static_cast<std::uint8_t>(arguments.iterations);
  request.options.key = arguments.key == "nearest"    ? SortKey::nearest
                        : arguments.key == "farthest" ? SortKey::farthest
                                                      : SortKey::middle;
  const auto culls = [&](const char* what) { return std::ranges::find(arguments.cull, what) != arguments.cull.end(); };
  if (culls("none") && arguments.cull.size() > 1) {
    return Failure{ExitStatus::usage, "--cull none goes with nothing else"};
  }
  request.options.cull_back_faces = culls("back-faces");
  request.options.cull_small = culls("small");
  request.options.cull_by_spheres = culls("spheres");
  const VisibilityOptions usual;
  if (request.options.cull_back_faces != usual.cull_back_faces || request.options.cull_small != usual.cull_small ||
      request.options.cull_by_spheres != usual.cull_by_spheres) {
    request.method = request.method | method::culling;
  }
  if (!arguments.sets.empty()) {
    if (request.method.any(method::orders)) {
      return Failure{
          ExitStatus::usage,
          fmt::format("--visible-sets are of the scene's meshlets, which --visibility {} splits into others; "
                      "leave out one of them",
                      visibility_name(request.method))};
    }
    request.method = request.method | method::culling;
  }
  if (!arguments.show.empty()) {
    const Result<Show> show = parse_show(arguments.show);
    if (!show) return show.failure();
    request.show = *show;
  }
  return request;
}

}  // namespace zstrip::sim
