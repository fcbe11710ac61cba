// The rectangle that differs from a frame before, from digests of places and from rectangles of instances.
#include <algorithm>

#include "zstrip/effects/edges/apron.hpp"
#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip/state/digest.hpp"
#include "zstrip_player/player.hpp"

namespace zstrip {
namespace {

using detail::Digest;

/// Extends `all` by `part`; both may be empty.
void extend(Rect& all, const Rect& part) {
  if (part.empty()) return;
  all = all.empty() ? part
                    : Rect{std::min(all.left, part.left), std::min(all.top, part.top), std::max(all.right, part.right),
                           std::max(all.bottom, part.bottom)};
}

}  // namespace

/// Returns the rectangle of an instance in the frame that was begun last.
Rect Player::rectangle_of(std::size_t instance) const {
  const detail::CompiledInstance& compiled = state_.instances[instance];
  if (!compiled.visible) return {};
  const Rect box =
      detail::bounds_of(compiled, state_.origin, state_.view, staged_.camera.projection == Projection::orthographic);
  return detail::pixels_of(box, state_.view);
}

Rect Player::changed() {
  if (!is_open_ || !is_fitted_ || state_.scene == nullptr) return {};
  Digest picture(1), scene(1);
  picture.add(staged_.scene.background);
  if (staged_text_[0] != 0) {
    for (const char letter : staged_text_) picture.add(std::int32_t{letter});
    picture.add_one(&overlay_.fonts.back());
  }
  const Camera& camera = staged_.camera;
  for (const Vec3& vector : {camera.right, camera.up, camera.back, camera.eye}) scene.add(vector);
  scene.add(camera.focal);
  scene.add(state_.fit.near);  // depth is rounded, and fog computed, by the range of the whole scene
  scene.add(state_.fit.far);
  for (const LineSet& lines : staged_.scene.lines) scene.add_one(&lines.transform);
  const auto add_place = [this](Digest& digest, const Instance& instance) {
    digest.add_one(&instance.transform);
    if (!baked_.levels.empty()) digest.add(instance.mesh);
    for (const MovedMorph& morph : baked_.morphs.meshes) {
      if (morph.mesh == instance.mesh) digest.add(weights_);
    }
    if (baked_.scene.meshes[instance.mesh].skinning != nullptr) digest.add(staged_pose_);
  };
  const bool each = !seen_instances_.empty() && !reaches_far_;
  Rect moved{};
  for (std::size_t i = 0; i < staged_.scene.instances.size(); ++i) {
    const Instance& instance = staged_.scene.instances[i];
    if (!each) {
      add_place(scene, instance);
      continue;
    }
    Digest place(1);
    add_place(place, instance);
    SeenInstance& seen = seen_instances_[i];
    const Rect now = rectangle_of(i);
    // Before the first frame nothing is seen, and the rectangle is the whole picture.
    if (seen_.is_known && seen.place != place.value()) {
      extend(moved, {seen.left, seen.top, seen.right, seen.bottom});
      extend(moved, now);
    }
    const auto side = [](std::int32_t length) { return static_cast<std::uint16_t>(length); };
    seen = {place.value(), side(now.left), side(now.top), side(now.right), side(now.bottom)};
  }
  const Rect bounds = detail::pixels_of(state_.bounds, state_.view);
  if (seen_.is_known && seen_.scene != scene.value()) {
    extend(moved, seen_.bounds);
    extend(moved, bounds);
  }
  if (!baked_.scene.edges.empty() && !moved.empty()) moved = detail::edges::strip_with_apron(moved, view_);
  if (!seen_.is_known || seen_.picture != picture.value()) moved = {0, 0, view_.width, view_.height};
  seen_ = {.is_known = true, .picture = picture.value(), .scene = scene.value(), .bounds = bounds};
  return moved;
}

}  // namespace zstrip
