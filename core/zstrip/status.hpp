// Errors as values: what went wrong, for which purpose, how much was needed and how much was there.
#pragma once

#include <cstdint>

#include "zstrip/base/language.hpp"

namespace zstrip {

/// What is wrong. In brackets what Status::needed and Status::available then hold.
enum class Error : std::uint8_t {
  none,               ///< success
  arena_too_small,    ///< `needed`, `available` in bytes; `purpose`: for what
  pixels_too_small,   ///< the caller's strip buffer; `needed`, `available` in bytes
  pixels_misaligned,  ///< RGB565 pixels must lie at an even address
  view_size,   ///< width or height outside 1..4096, or a format that does not exist; with several samples a pixel,
               ///< those of a row or column (`needed` = given, `available` = limit)
  strip_rows,  ///< more strip rows than the picture has, a strip index out of range, or rows that end within tiles of a
               ///< static layer (`needed` = given, `available` = limit)
  strip_columns,   ///< neither a multiple of 8 nor the picture's width (`needed` = given, `available` = the width)
  unplannable,     ///< more than 65,535 strips, or too many meshlets or triangles in one for bins (32,767)
  camera,          ///< not 0 < near < far, focal length <= 0, or axes that are not set
  mesh,            ///< index out of range, no positions, size or bits out of range (`needed` = index of the mesh)
  instance,        ///< refers to a mesh or material that does not exist, a transform out of range, or a mesh that
                   ///< repeats the material's texture too often (`needed` = index of the
                   ///< instance)
  material,        ///< refers to a texture or a finish that does not exist (`needed` = index of the material)
  texture,         ///< no texels, or more than 2^11 on a side (`needed` = index of the texture)
  light,           ///< too many lights (`needed` = given, `available` = limit)
  effect_missing,  ///< the scene calls for effects that this renderer was built without: missing_effects(status) are
                   ///< those (`needed` = lower 32 bits of the set, `available` = upper), none where the renderer is for
                   ///< orthographic cameras only
  not_begun,       ///< draw_strip before a successful begin_frame
  store_full,      ///< a store's pool has no room for a tile; `needed`, `available` in bytes of the pool
  store_range,     ///< a tile or rows that a store does not have (`needed` = the row beyond, `available` = its rows),
                   ///< or a format of pixels that it does not keep
  store_damaged,   ///< bytes that are no store of this kind, or no record of a tile (`needed` = index of the tile)
  blob_alignment,  ///< a scene blob, or the memory lent for it, at an address that is not aligned
  blob_damaged,    ///< bytes that are no whole scene blob (`needed` = the byte that is wrong)
  blob_version,    ///< a scene blob of another version (`needed` = its version, `available` = the one that is read)
  blob_memory,     ///< the memory lent for a scene blob; `needed`, `available` in bytes
  depth_effects,   ///< two depth formats at once, sub-ranges of one that has none, or one that needs a perspective
                   ///< camera and is to draw an orthographic one
  fog,             ///< not 0 <= start < end, a negative density, or no mode
  quadric,         ///< refers to a material that does not exist or needs what quadrics do not have (a slope bias, a
                   ///< finish, punctual lights, alpha in its texture), or a transform that is out of
                   ///< range or has no inverse (`needed` = index of the quadric)
  animation,       ///< a track that names no instance or keyframes, or keyframes out of range (`needed` = its index)
  finish,          ///< a mode or filter that does not exist, or more than 255 (`needed` = index of the finish)
  punctual_light,  ///< a negative intensity or range, or cones that are none (`needed` = its index)
  visibility,      ///< visibility methods that exclude each other or a depth effect, a draw_over with one, or without
                   ///< the tree that it needs (`needed` = the methods)
  lines,           ///< refer to a mesh, vertex or material that does not exist or need what lines do not have (a
                   ///< texture, a finish, a slope bias), a transform or a width out of range, or a mesh too large
                   ///< beside the depth range (`needed` = index of the set)
  samples,         ///< View::samples is none of 1, 2, 4, or what was requested, a static layer or a draw_over, is not
                   ///< there with several (`needed` = View::samples)
  outline,         ///< a width out of range, a hull that does not exist or has no normals, or an instance that has it
                   ///< and a mask or blends; more than 255 (`needed` = its index)
  shadow,          ///< a light that does not exist, a size or bias out of range, a material whose depth test passes
                   ///< farther, casters too large or too far away for a map; or what was requested, a static layer or a
                   ///< draw_over, is not there with shadows
  csg,    ///< an operand that does not exist or is no plain solid (blended, masked, a billboard, with an outline
          ///< or rules of its own for depth), a product that nothing is intersected in, products out of order,
          ///< more than kMaxCsgOperands (`needed` = index of the operand); or what was requested, a shadow or a
          ///< draw_over, is not there with products (`needed` = their operands)
  edges,  ///< a set that refers to a mesh or vertex that does not exist, or not in the order of meshes (`needed` = its
          ///< index); or what was requested, outlines, a shadow, CSG, several samples, a static layer or
          ///< a draw_over, is not there with them
  blob_section,  ///< a scene blob with a section that must be known and is not (`needed` = its tag, the first letter in
                 ///< the highest byte): it is newer than this program
  overlay,   ///< a size, coverage, glyph or number of bytes that is wrong, or a sprite or label that refers to no image
             ///< or font (`needed` = its index, `available` = its OverlayPart); or a draw_over, where there is none
  skin,      ///< counts that differ, parents behind their children, weights that do not add up, a joint that does not
             ///< exist or leads too far away, or a vertex that leaves the mesh's box (`needed` = index of the joint or
             ///< vertex)
  clipping,  ///< an instance whose box comes near the near plane, or lies more than a thousand pixels beside the
             ///< picture's centre, in a renderer with effect::unclipped (`needed` = its index)
  blob_depth,  ///< a scene blob for a depth format that is gone (`needed` = its number)
};

/// What memory is for. The order is that of a plan's table.
enum class Purpose : std::uint8_t {
  none,         ///< not about memory
  instances,    ///< transforms of instances, quadrics and sets of lines
  extents,      ///< which strips each meshlet touches
  vertices,     ///< of one meshlet, or of all where they are binned
  depth,        ///< of a strip
  colour,       ///< a strip in RGB565, where it is not drawn in place
  bins,         ///< triangles that wait for their strips
  layer,        ///< a static layer
  effects,      ///< what effects keep through a frame
  sorting,      ///< the order of triangles, of some visibility methods
  depth_bounds  ///< of tiles, of some visibility methods
};

/// `error == Error::none` is success; converts to true then. [[nodiscard]]: nothing fails in silence.
struct [[nodiscard]] Status {
  Error error = Error::none;        ///< what is wrong
  Purpose purpose = Purpose::none;  ///< what memory was for, where some is missing
  std::uint32_t needed = 0;         ///< see Error
  std::uint32_t available = 0;      ///< see Error

  /// Whether all is well.
  constexpr explicit operator bool() const { return error == Error::none; }
  friend constexpr bool operator==(const Status&, const Status&) = default;
};

/// A short English phrase without a full stop, in static storage.
const char* message(Error error);
/// One word, in static storage.
const char* name(Purpose purpose);

}  // namespace zstrip
