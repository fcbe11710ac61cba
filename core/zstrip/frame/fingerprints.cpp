// Takes the fingerprints of a frame's strips; see fingerprints.hpp.
#include "zstrip/fingerprints.hpp"

#include <algorithm>

#include "zstrip/effects/edges/apron.hpp"
#include "zstrip/effects/overlay/text_line.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/parts.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip/state/digest.hpp"

namespace zstrip::detail {
namespace {

constexpr std::uint32_t kUnknown = 0;
static_assert(kUnknown == Digest::kNever);

/// The fingerprints of a frame's strips while they are collected.
class Strips {
 public:
  Strips(const FrameState& frame, std::uint32_t of_background, std::span<std::uint32_t> fingerprints)
      : grid_(frame.plan, frame.view, {0, 0, frame.view.width, frame.view.height}), fingerprints_(fingerprints) {
    const std::size_t known = std::min<std::size_t>(frame.plan.strips, fingerprints.size());
    std::ranges::fill(fingerprints.first(known), of_background);
    std::ranges::fill(fingerprints.subspan(known), kUnknown);
  }

  /// Adds something to the strips that it may touch: all pixels of the frame's view in `box`. After kUnknown they
  /// stay unknown.
  void add(const Rect& box, std::uint32_t print) {
    const Rect touched = grid_.strips_of_picture(box);
    for (std::int32_t row = touched.top; row < touched.bottom; ++row) {
      for (std::int32_t column = touched.left; column < touched.right; ++column) {
        const auto strip = static_cast<std::uint32_t>(row * grid_.across() + column);
        if (strip >= fingerprints_.size() || fingerprints_[strip] == kUnknown) continue;
        Digest both(fingerprints_[strip]);
        both.add(print);
        fingerprints_[strip] = print == kUnknown ? kUnknown : both.value();
      }
    }
  }

 private:
  StripGrid grid_;
  std::span<std::uint32_t> fingerprints_;
};

/// Returns the digest of a strip that shows the background alone.
Digest digest_of_background(const FrameState& frame) {
  Digest digest(1);
  digest.add(std::uint32_t{frame.view.width} << 16U | frame.view.height);
  // Fog dithers the background, too.
  digest.add(std::uint32_t{frame.scene->fog != nullptr} << 31U | static_cast<std::uint32_t>(frame.view.format) << 16U |
             std::uint32_t{frame.view.dither} << 8U | frame.view.samples);
  digest.add(frame.scene->background);
  return digest;
}

template <class Record>
void add_setting(Digest& digest, std::span<const Record> records) {
  digest.add_all(records);
}
template <class Record>
void add_setting(Digest& digest, const Record* record) {
  digest.add_one(record);
}
/// The background is in its own digest, too.
void add_setting(Digest& digest, const Colour& colour) { digest.add(colour); }
// These parts change only the strips that they touch. Strips with hulls of outlines have no fingerprint.
void add_setting(Digest&, std::span<const Instance>) {}
void add_setting(Digest&, std::span<const Quadric>) {}
void add_setting(Digest&, std::span<const LineSet>) {}
void add_setting(Digest&, std::span<const Outline>) {}
void add_setting(Digest&, const Overlay*) {}

/// Adds the settings that every surface may depend on. A new part of scenes is one of them unless it is named above.
void add_settings(Digest& digest, const FrameState& frame, const Camera& camera) {
  for (const Vec3& axis : {camera.right, camera.up, camera.back, camera.eye}) digest.add(axis);
  for (const Fixed length : {camera.focal, camera.near_plane, camera.far_plane}) digest.add(length);
  digest.add(static_cast<std::uint32_t>(camera.projection) << 1U | std::uint32_t{camera.fixed_depth_range});
  // Depth codes depend on the depths of all instances.
  digest.add(frame.fit.near);
  digest.add(frame.fit.far);
  for_each_part(*frame.scene, [&digest](const char*, const auto& part) { add_setting(digest, part); });
}

/// True if outlines were added to the frame, whose hulls are wider than their boxes.
bool has_outlines(const Scene& scene) {
  return std::ranges::any_of(scene.instances,
                             [&](const Instance& instance) { return scene.meshes[instance.mesh].outline != 0; });
}

/// Adds the surfaces that are drawn into the z-buffer.
void add_surfaces(Strips& strips, const FrameState& frame, const Camera& camera, const Digest& settings) {
  const Scene& scene = *frame.scene;
  if (has_outlines(scene)) return strips.add(frame.bounds, kUnknown);
  // A shadow or a solid may change where its own instance does not. An edge changes with its neighbours alone.
  const bool connected = scene.shadow != nullptr || !scene.csg.empty();
  const auto add = [&](const Rect& box, std::uint32_t print) {
    if (!box.empty()) strips.add(scene.edges.empty() ? box : edges::box_with_apron(box), print);
  };
  bool known = true;
  Digest all = settings;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const bool is_known = scene.meshes[instance.mesh].skinning == nullptr;
    if (connected) {
      all.add_one(&instance);
      known = known && is_known;
    } else if (frame.instances[i].visible) {
      Digest own = settings;
      own.add_one(&instance);
      add(bounds_of(frame.instances[i], frame.origin, frame.view, camera.projection == Projection::orthographic),
          is_known ? own.value() : kUnknown);
    }
  }
  if (!connected && scene.quadrics.empty() && scene.lines.empty()) return;
  all.add_all(scene.quadrics);
  all.add_all(scene.lines);
  add(frame.bounds, known ? all.value() : kUnknown);
}

/// Adds sprites and labels to the rows that they may touch. `seed`: of all of them.
void add_overlay(Strips& strips, const View& view, const Overlay& overlay, const Digest& seed) {
  const auto add_rows = [&](std::int32_t top, std::int32_t bottom, const Digest& digest) {
    const auto samples = static_cast<std::int32_t>(sample_rows(view));
    strips.add({0, top * samples, view.width, bottom * samples}, digest.value());
  };
  for (const Sprite& sprite : overlay.sprites) {
    const OverlayImage& image = overlay.images[sprite.image];
    Digest digest = seed;
    digest.add(sprite.x);
    digest.add(sprite.y);
    digest.add(sprite.colour);
    digest.add_one(&image);
    add_rows(sprite.y, sprite.y + image.height, digest);
  }
  for (const Label& label : overlay.labels) {
    const Font& font = overlay.fonts[label.font];
    Digest digest = seed;
    digest.add(label.x);
    digest.add(label.y);
    digest.add(static_cast<std::uint32_t>(label.alignment));
    digest.add(label.colour);
    digest.add(label.background);
    digest.add_one(&font);
    std::int32_t lines = 1;
    for (const char character : whole_text(label.text)) {
      digest.add(static_cast<std::uint32_t>(static_cast<unsigned char>(character)));
      if (character == '\n') ++lines;
    }
    // Glyphs may reach beyond their line by its height.
    add_rows(label.y - font.line_height, label.y + (lines + 1) * font.line_height, digest);
  }
}

}  // namespace

void take_fingerprints(const FrameState& frame, const Camera& camera, std::uint32_t version,
                       std::span<std::uint32_t> fingerprints) {
  if (frame.scene == nullptr) {
    std::ranges::fill(fingerprints, kUnknown);
    return;
  }
  const Digest background = digest_of_background(frame);
  Strips strips(frame, background.value(), fingerprints);
  Digest settings = background;
  settings.add(version);
  add_settings(settings, frame, camera);
  add_surfaces(strips, frame, camera, settings);
  if (frame.scene->overlay != nullptr) {
    Digest seed(2);
    seed.add(version);
    add_overlay(strips, frame.view, *frame.scene->overlay, seed);
  }
}

}  // namespace zstrip::detail
