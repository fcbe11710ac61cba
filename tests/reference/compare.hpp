// Judges a picture of the renderer by samples of the reference around each pixel's centre.
//
// The renderer snaps vertices to 1/16 pixel, so that what it shows at a pixel's centre is what the exact scene shows
// within kReach of it. Where all samples within reach show one surface, the pixel is *certain*: it must be that
// surface, in its colour. Elsewhere, at an edge, at the border of a texel, where surfaces cross or lie within the
// resolution of depth, it must be one of those that are in reach. Triangles thinner than the distance of the samples
// slip between them; these are looked for one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

#include "reference_picture.hpp"
#include "renderer_picture.hpp"

namespace zstrip::reference {

enum class Verdict : std::uint8_t {
  background,  ///< certainly, and so it is
  certain,     ///< one surface, in its colour
  plausible,   ///< one of the surfaces in reach
  sliver,      ///< a triangle in reach that no sample hits, or a texel of it that none shows
  foreign,     ///< none of those: wrong
  coverage,    ///< certain, and drawn by one of the two only: wrong
  shading,     ///< certain, in another colour: wrong
};
inline constexpr std::size_t kVerdicts = 7;

/// Errors of colour count in units of an 8-bit channel.
struct Comparison {
  std::vector<Verdict> verdicts;         ///< one a pixel
  std::uint32_t count[kVerdicts] = {};   ///< of each verdict
  std::uint32_t drawn = 0;               ///< pixels with a surface at their centre, in the reference
  std::uint32_t exact = 0;               ///< of these, pixels that fit that very surface
  std::uint32_t silhouette_differs = 0;  ///< drawn in one picture, background in the other
  std::uint32_t silhouette_strays = 0;   ///< of these, more than one pixel away from anything drawn in the other
  double mean_error = 0;    ///< of certain pixels against the reference truncated to RGB565, both widened to 8 bits
  double worst_error = 0;   ///< likewise
  double worst_excess = 0;  ///< of certain pixels

  std::uint32_t of(Verdict verdict) const { return count[static_cast<std::size_t>(verdict)]; }
};

/// `excess`: by how much a colour in reach may miss all those that truncate to the pixel.
Comparison compare(const RendererPicture& picture, const ReferencePicture& reference, double excess);

/// One line with all counts.
std::ostream& operator<<(std::ostream& out, const Comparison& comparison);

/// The colour in RGB565, each channel clamped and truncated.
std::uint16_t truncated(const Sample& sample);

}  // namespace zstrip::reference
