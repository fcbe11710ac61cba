// Errors as values: the kind of error, the purpose of the memory, the amount needed and the amount available.
#pragma once

#include <cstdint>

#include "zstrip/base/language.hpp"

namespace zstrip {

/// The kind of error. In brackets the meaning of Status::needed and Status::available.
enum class Error : std::uint8_t {
  none,               ///< no error
  arena_too_small,    ///< `needed`, `available` in bytes; `purpose`: the use of the memory
  pixels_too_small,   ///< the caller's strip buffer; `needed`, `available` in bytes
  pixels_misaligned,  ///< RGB565 pixels must lie at an even address
  view_size,   ///< width or height outside 1..4096, or a format that does not exist; with several samples a pixel the
               ///< samples of a row or column count (`needed` = given, `available` = limit)
  strip_rows,  ///< more strip rows than the picture has, a strip index out of range, or a strip that ends inside tiles
               ///< of a static layer (`needed` = given, `available` = limit)
  strip_columns,   ///< neither a multiple of 8 nor the picture's width (`needed` = given, `available` = the width)
  unplannable,     ///< more than 65,535 strips, or too many meshlets, or too many triangles in one meshlet for bins
                   ///< (32,767)
  camera,          ///< 0 < near < far is false, a focal length <= 0, or axes that are not set
  mesh,            ///< index out of range, no positions, size or bits out of range (`needed` = index of the mesh)
  instance,        ///< a mesh or material that does not exist, a transform out of range, or a mesh that repeats the
                   ///< material's texture too often (`needed` = index of the instance)
  material,        ///< a texture or a finish that does not exist (`needed` = index of the material)
  texture,         ///< no texels, or a side of more than 2^11 texels (`needed` = index of the texture)
  light,           ///< too many lights (`needed` = given, `available` = limit)
  effect_missing,  ///< the scene needs effects that this renderer was built without: missing_effects(status) returns
                   ///< them (`needed` = lower 32 bits of the set, `available` = upper); the set is empty if the
                   ///< renderer is for orthographic cameras only
  not_begun,       ///< draw_strip before a successful begin_frame
  store_full,      ///< a store's pool has no room for a tile; `needed`, `available` in bytes of the pool
  store_range,     ///< a tile or rows that a store does not have (`needed` = the row beyond, `available` = its rows),
                   ///< or a pixel format that it cannot keep
  store_damaged,  ///< bytes that are not a store of this kind, or not a record of a tile (`needed` = index of the tile)
  blob_alignment,  ///< the address of a scene blob, or of the memory lent for it, is not aligned
  blob_damaged,    ///< bytes that are not a complete scene blob (`needed` = offset of the wrong byte)
  blob_version,    ///< a scene blob of another version (`needed` = its version, `available` = the supported version)
  blob_memory,     ///< too little memory lent for a scene blob; `needed`, `available` in bytes
  depth_effects,   ///< two depth formats at once, sub-ranges of a format that has none, or a format for perspective
                   ///< cameras with an orthographic one
  fog,             ///< 0 <= start < end is false, a negative density, or a mode that does not exist
  quadric,         ///< a material that does not exist or is not for quadrics (it has a slope bias, a finish,
                   ///< punctual lights, alpha in its texture), or a transform that is out of range or has no inverse
                   ///< (`needed` = index of the quadric)
  animation,       ///< a track with an instance or keyframes that do not exist, or keyframes out of range (`needed` =
                   ///< its index)
  finish,          ///< a mode or filter that does not exist, or more than 255 finishes (`needed` = index of the finish)
  punctual_light,  ///< a negative intensity or range, or invalid cones (`needed` = its index)
  visibility,      ///< visibility methods that exclude each other or a depth effect, a draw_over with a method, or a
                   ///< method without the tree that it needs (`needed` = the methods)
  lines,           ///< a mesh, vertex or material that does not exist, a material that is not for lines
                   ///< (a texture, a finish, a slope bias), a transform or a width out of range, or a mesh too large
                   ///< for the depth range (`needed` = index of the set)
  samples,         ///< View::samples is not 1, 2 or 4, or several samples are combined with a static layer or a
                   ///< draw_over (`needed` = View::samples)
  outline,         ///< a width out of range, a hull that does not exist or has no normals, or an instance with an
                   ///< outline that is masked or blended; more than 255 outlines (`needed` = its index)
  shadow,          ///< a light that does not exist, a size or bias out of range, a material whose depth test passes
                   ///< farther, casters too large or too far away for a map; or shadows combined with a static layer or
                   ///< a draw_over
  csg,    ///< an operand that does not exist or is not a plain solid (it is blended, masked or a billboard, or has an
          ///< outline or its own rules for depth), a product without an intersected operand, products out of order,
          ///< more than kMaxCsgOperands (`needed` = index of the operand); or products combined with a shadow or a
          ///< draw_over (`needed` = their operands)
  edges,  ///< a set with a mesh or vertex that does not exist, or out of the order of meshes (`needed` = its index); or
          ///< edges combined with outlines, CSG, several samples, a static layer or a draw_over
  blob_section,  ///< a scene blob with a required section that this program does not know, because the blob is newer
                 ///< (`needed` = its tag, the first letter in the highest byte)
  overlay,   ///< a wrong size, coverage, glyph or number of bytes, or a sprite or label whose image or font does not
             ///< exist (`needed` = its index, `available` = its OverlayPart); or a draw_over, which cannot draw
             ///< overlays
  skin,      ///< counts that differ, a parent after its children, weights that do not add up, a joint that does not
             ///< exist or moves its vertices too far away, or a vertex that leaves the mesh's box (`needed` = index of
             ///< the joint or vertex); or a morph target whose runs or weight are out of range (`needed` = its index)
  clipping,  ///< an instance whose box is close to the near plane, or more than a thousand pixels away from the
             ///< picture's centre, in a renderer with effect::unclipped (`needed` = its index)
  blob_depth,  ///< a scene blob for a depth format that was removed (`needed` = its number)
};

/// The use of memory, in the order of a plan's table.
enum class Purpose : std::uint8_t {
  none,         ///< not about memory
  instances,    ///< transforms of instances, quadrics and sets of lines
  extents,      ///< the strips that each meshlet touches
  vertices,     ///< transformed vertices of one meshlet, or of all meshlets in Mode::binned
  depth,        ///< z-buffer of a strip
  colour,       ///< a strip in RGB565, if it is not drawn in place
  bins,         ///< lists of the triangles of each strip
  layer,        ///< a static layer
  effects,      ///< data that effects keep during a frame
  sorting,      ///< the order of triangles, for some visibility methods
  depth_bounds  ///< bounds of depth of tiles, for some visibility methods
};

/// `error == Error::none` is success; a Status then converts to true. [[nodiscard]]: an ignored error is a warning.
struct [[nodiscard]] Status {
  Error error = Error::none;        ///< the kind of error
  Purpose purpose = Purpose::none;  ///< the use of the memory, if memory is missing
  std::uint32_t needed = 0;         ///< see Error
  std::uint32_t available = 0;      ///< see Error

  /// True if error is Error::none.
  constexpr explicit operator bool() const { return error == Error::none; }
  friend constexpr bool operator==(const Status&, const Status&) = default;
};

/// Returns a short English phrase without a full stop, in static storage.
const char* message(Error error);
/// Returns one word, in static storage.
const char* name(Purpose purpose);

}  // namespace zstrip
