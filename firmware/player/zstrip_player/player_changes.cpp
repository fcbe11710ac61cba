// The rectangle that differs from a frame before, from hashes of places and from rectangles of instances.
#include <algorithm>

#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip_player/player.hpp"

namespace zstrip {
namespace {

/// FNV-1a with words instead of bytes. Two places of an instance have the same hash with a probability of 2^-32.
class Hash {
 public:
  void add(std::uint32_t word) { value_ = (value_ ^ word) * 16777619U; }
  void add(std::int32_t word) { add(static_cast<std::uint32_t>(word)); }
  void add(std::int64_t words) {
    add(static_cast<std::uint32_t>(words));
    add(static_cast<std::uint32_t>(words >> 32));
  }
  void add(const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(const Transform& transform) {
    for (const auto& row : transform.m) {
      for (const Fixed entry : row) add(entry);
    }
  }
  void add(const Camera& camera) {
    add(camera.right);
    add(camera.up);
    add(camera.back);
    add(camera.eye);
    add(camera.focal);
  }
  std::uint32_t value() const { return value_ ^ value_ >> 15; }  // the upper bits depend on all words

 private:
  std::uint32_t value_ = 2166136261U;
};

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
  Hash picture, scene;
  const Colour& background = staged_.scene.background;
  picture.add(static_cast<std::uint32_t>(background.r | background.g << 8 | background.b << 16));
  for (const char letter : text_) picture.add(std::int32_t{letter});
  scene.add(staged_.camera);
  scene.add(state_.fit.near);  // depth is rounded, and fog computed, by the range of the whole scene
  scene.add(state_.fit.far);
  for (const LineSet& lines : staged_.scene.lines) scene.add(lines.transform);
  const auto add_place = [this](Hash& hash, const Instance& instance) {
    hash.add(instance.transform);
    if (baked_.scene.meshes[instance.mesh].skinning == nullptr) return;
    for (const PlayedClip& played : played_.all()) {
      hash.add(played.time);
      hash.add(std::uint32_t{played.clip});
      hash.add(played.share());
    }
  };
  const bool each = !seen_instances_.empty() && !reaches_far_;
  Rect moved{};
  for (std::size_t i = 0; i < staged_.scene.instances.size(); ++i) {
    const Instance& instance = staged_.scene.instances[i];
    if (!each) {
      add_place(scene, instance);
      continue;
    }
    Hash place;
    add_place(place, instance);
    SeenInstance& seen = seen_instances_[i];
    const Rect now = rectangle_of(i);
    if (!seen_.is_known || seen.place != place.value()) {
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
  if (!seen_.is_known || seen_.picture != picture.value()) moved = {0, 0, view_.width, view_.height};
  seen_ = {.is_known = true, .picture = picture.value(), .scene = scene.value(), .bounds = bounds};
  return moved;
}

}  // namespace zstrip
