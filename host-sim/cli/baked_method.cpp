// Settles the visibility method of `zstrip bake`; see baked_method.hpp.
#include "cli/baked_method.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/picture_arguments.hpp"
#include "cli/print.hpp"
#include "visibility/methods.hpp"
#include "visibility/tree_stage.hpp"

namespace zstrip::sim {
namespace {

/// Blobs keep the triangles that a method orders; the program for the Pico does not draw them in that order.
bool keeps_method(BakeKind kind, Effects chosen) {
  return is_source(kind) || (kind == BakeKind::blob && chosen.any(method::orders));
}

/// Warns of the scene file's visibility settings that the output does not keep.
Result<Done> warn_of_method(BakeKind kind, const std::string& scene, Effects method) {
  const Result<PictureSettings> settings = settings_of(scene);
  if (!settings) return settings.failure();
  const VisibilitySettings& from = settings->visibility;
  if (kind == BakeKind::pico) {
    print_warning("'visibility' of the scene file is left out: the program for the Pico draws with a z-buffer");
  } else if (kind == BakeKind::blob) {
    std::string options;
    if (from.iterations) options += fmt::format(" --iterations {}", *from.iterations);
    if (from.sort_key) options += fmt::format(" --sort-key {}", *from.sort_key);
    print_warning(fmt::format(
        "a blob does not keep 'visibility' of the scene file: the program that draws it chooses the method, as zstrip "
        "render --visibility {}{}{}",
        visibility_name(method), options, keeps_method(kind, method) ? "" : "; memory is planned with a z-buffer"));
  } else if (from.iterations || from.sort_key) {
    print_warning(fmt::format(
        "a header does not keep '{}' of the scene file: the program that draws it sets that in VisibilityOptions",
        from.iterations ? "iterations" : "sort_key"));
  }
  return Done{};
}

}  // namespace

Result<Done> settle_method(BakeKind kind, const std::string& scene, bool is_option, Effects& method) {
  if (method == Effects{}) return Done{};
  const bool kept = keeps_method(kind, method);
  if (!is_option) {
    if (const Result<Done> warned = warn_of_method(kind, scene, method); !warned) return warned.failure();
    if (!kept) method = {};
    return Done{};
  }
  if (kept) return Done{};
  return Failure{
      ExitStatus::usage,
      fmt::format("--visibility {}: {}; leave it out, or bake a header (-o FILE.hpp), which keeps the method",
                  visibility_name(method),
                  kind == BakeKind::pico
                      ? "the program for the Pico draws with a z-buffer"
                      : "a blob keeps only painter-newell and painter-bsp, and the program that draws "
                        "it chooses any other method")};
}

Result<PreparedScene> prepare_for(Effects method, bool has_visible_sets, const Staging& staging,
                                  const Animation& animation, const BakedSkins& skins) {
  if (has_visible_sets && skins.move()) {
    return Failure{ExitStatus::usage,
                   "--visible-sets are of meshlets that keep their shape, and here joints or morph targets move their "
                   "vertices; leave "
                   "it out"};
  }
  if (method.any(zstrip::method::orders)) {
    const std::string_view name = visibility_name(method);
    if (!animation.tracks.empty() || skins.move()) {
      return Failure{ExitStatus::usage,
                     fmt::format("--visibility {} orders triangles that stand still, and here some move; bake with "
                                 "another method",
                                 name)};
    }
    if (has_visible_sets) {
      return Failure{
          ExitStatus::usage,
          fmt::format("--visible-sets are of the scene's meshlets, which --visibility {} splits into others; "
                      "leave out one of them",
                      name)};
    }
  }
  return PreparedScene::of(staging, method);
}

Result<Turn> turn_of(const Stage& stage, Effects method, bool turntable, const Staging& original) {
  if (!method.any(zstrip::method::orders) || stage.turn().what == Turning::nothing) return stage.turn();
  const bool by_tree = method.has(zstrip::method::bsp);
  if (by_tree) {
    if (const std::optional<Turn> turn = turn_of_tree(stage, original.scene.instances.size())) return *turn;
  }
  const std::string why = fmt::format(
      "--visibility {} {}", visibility_name(method),
      by_tree ? "joins instances that rotate and instances that do not" : "orders its triangles for one camera");
  if (turntable) {
    return Failure{ExitStatus::usage, why + "; leave out --turntable, or bake with another method"};
  }
  print_warning("the baked scene stands still where zstrip render turns it: " + why);
  return Turn{.what = Turning::nothing};
}

}  // namespace zstrip::sim
