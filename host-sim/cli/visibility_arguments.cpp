// The options for the visibility method, and for pictures of its work.
#include "cli/visibility_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/one_of.hpp"
#include "visibility/method_options.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {

void add_visibility_options(CLI::App& command, VisibilityArguments& arguments) {
  VisibilityArguments& a = arguments;
  command
      .add_option("--visibility", a.method,
                  fmt::format("The visibility method: {} (default: zbuffer)", visibility_names()))
      ->transform(lower_case())
      ->type_name("METHOD");
  command
      .add_option("--iterations", a.iterations,
                  fmt::format("Levels of splitting of the midpoint methods, 0 to {} (default: {})", kMaxIterations,
                              VisibilityOptions{}.iterations))
      ->option_text("N")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{kMaxIterations}));
  command
      .add_option("--sort-key", a.key, "The depth by which triangles are sorted: middle (default), nearest or farthest")
      ->option_text("KEY")
      ->transform(one_of({"middle", "nearest", "farthest"}));
  command
      .add_option("--cull", a.cull,
                  "The kinds of culling, separated by commas: back-faces, small, spheres (meshlets by their bounding "
                  "spheres), temporal (meshlets hidden in the last frame come last; hierarchical-z), or none. The list "
                  "replaces the default: back-faces,small")
      ->transform(lower_case())
      ->option_text("LIST")
      ->delimiter(',');
  command
      .add_option("--visible-sets", a.sets,
                  "Leave out the meshlets that cannot be seen from the camera's cell, as this file of zstrip bake says")
      ->type_name("FILE");
  command.add_option("--show", a.show, "Instead of the picture: depth, overdraw, tiles, error or accuracy")
      ->transform(lower_case())
      ->type_name("WHAT");
}

Result<VisibilityRequest> parse_visibility(const VisibilityArguments& arguments, const VisibilitySettings& settings) {
  const Result<VisibilityMethod> method =
      parse_visibility(arguments.method.value_or(settings.method.value_or("zbuffer")));
  if (!method) return method.failure();
  const auto unused = [&](std::string_view option, const std::string& methods) {
    return Failure{ExitStatus::usage,
                   fmt::format("{} means nothing to --visibility {}; leave it out, or choose one of: {}", option,
                               method->name, methods)};
  };
  if (arguments.iterations && !uses_iterations(method->effects)) {
    return unused("--iterations", methods_with_iterations());
  }
  if (arguments.key && !uses_sort_key(method->effects)) return unused("--sort-key", methods_with_sort_key());
  VisibilityRequest request{.method = method->effects, .options = {}, .sets = arguments.sets};
  if (request.sets.empty()) request.sets = settings.sets.value_or("");
  request.options.iterations = static_cast<std::uint8_t>(
      arguments.iterations.value_or(settings.iterations.value_or(request.options.iterations)));
  request.options.key =
      known_sort_key(arguments.key.value_or(settings.sort_key.value_or("middle"))).value_or(SortKey::middle);
  const Result<CullChoice> cull = parse_cull(arguments.cull.empty() ? settings.cull : arguments.cull);
  if (!cull) return Failure{cull.failure().status, "--cull " + cull.failure().message};
  request.options.cull_back_faces = cull->back_faces;
  request.options.cull_small = cull->small;
  request.options.cull_by_spheres = cull->spheres;
  request.temporal = cull->temporal;
  if (request.temporal && without(request.method, method::culling) != method::hierarchical_z) {
    const std::string_view given = arguments.cull.empty() ? "the scene file's 'cull' with temporal" : "--cull temporal";
    return Failure{ExitStatus::usage, fmt::format("{} needs the bounds of --visibility hierarchical-z, and not {}",
                                                  given, visibility_name(request.method))};
  }
  if (cull->is_special()) request.method = request.method | method::culling;
  if (!request.sets.empty()) {
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
