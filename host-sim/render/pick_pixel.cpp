// Finds what a pixel of a frame shows.
#include "render/pick_pixel.hpp"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "text/text.hpp"
#include "zstrip/pick.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {
namespace {

/// Returns the material's name; empty if it has none.
std::string material_of(const Picked& picked, const Scene& scene, const Origins& origins) {
  std::size_t material = SIZE_MAX;
  if (picked.shown == Shown::instance) material = scene.instances[picked.index].material;
  if (picked.shown == Shown::quadric) material = scene.quadrics[picked.index].material;
  if (picked.shown == Shown::line) material = scene.lines[picked.index].material;
  return material < origins.material_names.size() ? origins.material_names[material] : "";
}

}  // namespace

Result<PickedPixel> pick_pixel(const Staging& staging, const Origins& origins, const View& view, Effects added,
                               PixelPlace place) {
  if (place.x >= view.width || place.y >= view.height) {
    return Failure{ExitStatus::usage, fmt::format("--pick {},{} is outside of the picture, which has {}x{} pixels",
                                                  place.x, place.y, view.width, view.height)};
  }
  const Effects effects = effects_of(staging.scene, staging.camera) | effects_of(view) | added;
  const PlanResult planned = plan(count(staging.scene), view, effects, {.modes = Modes::streamed});
  if (!planned.status) return Failure{ExitStatus::internal, std::string("--pick: ") + message(planned.status.error)};
  std::vector<std::uint64_t> arena(planned.plan.bytes() / sizeof(std::uint64_t) + 1);
  AnyRenderer renderer(effects);
  const Status begun =
      renderer.begin_frame(staging.scene, staging.camera, view, planned.plan, std::as_writable_bytes(std::span(arena)));
  if (!begun) return Failure{ExitStatus::internal, std::string("--pick: ") + message(begun.error)};
  PickedPixel pixel{place, {}, {}, {}};
  const Status status = picker_for(effects)(renderer.frame(), place.x, place.y, pixel.picked);
  if (status.error == Error::csg) {
    return Failure{ExitStatus::usage, "--pick cannot say which solid of a product (csg) a pixel shows"};
  }
  if (!status) {
    return Failure{ExitStatus::usage, "--pick needs --depth-format z16 and no --perspective; leave them out"};
  }
  pixel.material = material_of(pixel.picked, staging.scene, origins);
  const bool is_instance = pixel.picked.shown == Shown::instance || pixel.picked.shown == Shown::outline;
  if (is_instance && pixel.picked.index < origins.instance_names.size()) {
    pixel.name = origins.instance_names[pixel.picked.index];
  }
  return pixel;
}

std::string words_of(const PickedPixel& pixel) {
  const Picked& picked = pixel.picked;
  const std::string name = pixel.name.empty() ? "" : fmt::format(" ({})", printable(pixel.name));
  std::string words;
  switch (picked.shown) {
    case Shown::background: return "background";
    case Shown::instance: words = fmt::format("instance {}{}, triangle {}", picked.index, name, picked.triangle); break;
    case Shown::outline: words = fmt::format("outline of instance {}{}", picked.index, name); break;
    case Shown::quadric: words = fmt::format("quadric {}", picked.index); break;
    case Shown::line: words = fmt::format("line {} of set {}", picked.triangle, picked.index); break;
    case Shown::sprite: words = fmt::format("sprite {}", picked.index); break;
    case Shown::label: words = fmt::format("label {}", picked.index); break;
  }
  if (!pixel.material.empty()) words += ", material " + printable(pixel.material);
  if (picked.textured) words += fmt::format(", texture {:.3f},{:.3f}", picked.u / 65536.0, picked.v / 65536.0);
  return words;
}

}  // namespace zstrip::sim
