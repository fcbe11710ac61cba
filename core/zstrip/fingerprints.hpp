// Fingerprints of strips: they tell which strips of a frame show the same pixels as in the frame before, so that these
// are neither drawn nor sent again. zstrip.hpp does not include it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/camera.hpp"
#include "zstrip/frame.hpp"

namespace zstrip {

namespace detail {

/// Sets as many fingerprints as the frame has strips; further ones are 0.
void take_fingerprints(const FrameState& frame, const Camera& camera, std::uint32_t version,
                       std::span<std::uint32_t> fingerprints);

}  // namespace detail

/// A number for each of the first `strips` strips of a frame. If it is equal in two frames, and not 0, the strip has
/// the same pixels in both; 0 means that nothing is known. It is found without drawing: a strip that nothing touches
/// depends on the background alone, any other one on camera, light, materials and tables of the scene, and on the
/// instances, sprites and labels whose boxes touch it. So a strip with a moving instance differs, and other strips
/// do not. With edges a box is a pixel wider on each side. Quadrics and lines count for all strips that the scene's
/// rectangle touches, as do all instances of scenes with shadows or CSG. Instances with outlines or Mesh::skinning have
/// no fingerprint.
///
/// Unequal strips have equal fingerprints with a probability of 2^-32. The tables that a Mesh, a Texture, a LineSet, an
/// EdgeSet, a Font or an OverlayImage refers to are not read: pass another `version` after the program has changed
/// them, and if another renderer draws the scene with other effects. A strip of the background alone does not depend on
/// `version`: if the other renderer dithers, let the display forget what it shows. Visibility methods that keep
/// something for the next frame need all strips.
template <std::size_t strips>
class StripFingerprints {
 public:
  /// Takes the fingerprints of a frame that has begun, and of the camera that begin_frame got.
  StripFingerprints(const Frame& frame, const Camera& camera, std::uint32_t version = 0) {
    struct State : Frame {
      explicit State(const Frame& frame) : Frame(frame) {}
      const detail::FrameState& get() const { return state<detail::FrameState>(); }
    };
    detail::take_fingerprints(State(frame).get(), camera, version, fingerprints_);
  }
  /// Returns the fingerprint of a strip, 0 if there is none.
  std::uint32_t operator[](std::uint16_t strip) const { return strip < strips ? fingerprints_[strip] : 0; }

 private:
  std::array<std::uint32_t, strips> fingerprints_;  // all of them are set
};

/// A frame that has begun, with fingerprints: present() of zstrip_hal/present.hpp does not draw the strips that a
/// display such as ChangedTiles shows already.
///     renderer.begin_frame(scene, camera, kView, kPlan, arena);
///     FingerprintedFrame<decltype(renderer), kPlan.strips> frame(renderer, camera);
///     present(frame, changes, layout, buffers);
template <class AnyKind, std::size_t strips>
class FingerprintedFrame {
 public:
  /// `camera`: the one that begin_frame got. `version`: see StripFingerprints. Refers to the renderer.
  FingerprintedFrame(AnyKind& renderer, const Camera& camera, std::uint32_t version = 0)
      : renderer_(renderer), fingerprints_(renderer.frame(), camera, version) {}

  /// See Renderer::draw_strip.
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) { return renderer_.draw_strip(strip, pixels); }
  /// Returns the fingerprint of a strip, 0 if nothing is known.
  std::uint32_t fingerprint(std::uint16_t strip) const { return fingerprints_[strip]; }

 private:
  AnyKind& renderer_;
  StripFingerprints<strips> fingerprints_;
};

}  // namespace zstrip
