// The text for errors and purposes.
#include "zstrip/status.hpp"

namespace zstrip {

const char* message(Error error) {
  switch (error) {
    case Error::none: return "no error";
    case Error::arena_too_small: return "the arena is too small";
    case Error::pixels_too_small: return "the pixel buffer of a strip is too small";
    case Error::pixels_misaligned: return "the pixel buffer must lie at an even address";
    case Error::view_size: return "a picture has 1 to 4096 samples a side and a known format";
    case Error::strip_rows: return "the strip does not exist in this picture";
    case Error::strip_columns: return "a strip's columns must be a multiple of 8 or the picture's width";
    case Error::unplannable: return "there would be too many strips, or there are too many meshlets for bins";
    case Error::camera: return "the camera is not usable";
    case Error::mesh: return "a mesh is not valid";
    case Error::instance: return "an instance is not valid";
    case Error::material:
      return "a material refers to a texture or a finish that does not exist, or its texture has a palette and it no "
             "finish";
    case Error::texture: return "a texture is not valid";
    case Error::light: return "too many lights";
    case Error::effect_missing: return "the renderer was built without an effect that the scene calls for";
    case Error::not_begun: return "draw_strip needs a successful begin_frame";
    case Error::store_full: return "the pool of a store is full";
    case Error::store_range: return "the store has no such tile or row, or no such pixels";
    case Error::store_damaged: return "the store is damaged";
    case Error::blob_alignment: return "a scene blob or the memory lent for it is not aligned";
    case Error::blob_damaged: return "the scene blob is damaged";
    case Error::blob_version: return "the scene blob has a version that is not read here; bake it again";
    case Error::blob_memory: return "the memory lent for the scene blob is too small";
    case Error::depth_effects: return "these depth effects exclude each other or this camera";
    case Error::finish: return "a material's finish is not valid";
    case Error::punctual_light: return "a point or spot light is not valid";
    case Error::fog: return "the fog needs 0 <= start < end and a density that is not negative";
    case Error::quadric: return "a quadric is not valid";
    case Error::animation: return "a track of the animation is not valid";
    case Error::visibility: return "these visibility methods exclude each other or what is asked of them";
    case Error::lines: return "a set of lines is not valid";
    case Error::samples: return "a pixel has 1, 2 or 4 samples, and with a static layer one";
    case Error::shadow:
      return "the shadow needs a light of the scene, a size of 2^4 to 2^10 texels, no static layer, and materials "
             "without a depth test for farther";
    case Error::csg:
      return "CSG has an operand that is not a plain solid, or nothing to intersect, or goes with a "
             "shadow, or over a static layer";
    case Error::edges:
      return "a set of edges is not valid, or goes with outlines, CSG, several samples or a static layer";
    case Error::blob_section: return "the scene blob has a section that is not known here";
    case Error::blob_depth:
      return "the scene blob is for a depth format that is gone: use z24, or float where memory is short";
    case Error::overlay:
      return "an image, font, sprite or label of the overlay is not valid, or something is drawn over other pixels";
    case Error::skin: return "a skin or morph is not valid, or moves the mesh out of its box";
    case Error::clipping: return "an instance comes too close to the camera for a renderer without clipping";
    case Error::outline: return "an outline is not valid, has a hull without normals or is of what is not opaque";
  }
  return "unknown error";
}

const char* name(Purpose purpose) {
  switch (purpose) {
    case Purpose::none: return "nothing";
    case Purpose::instances: return "instances";
    case Purpose::extents: return "extents";
    case Purpose::vertices: return "vertices";
    case Purpose::depth: return "depth";
    case Purpose::colour: return "colour";
    case Purpose::bins: return "bins";
    case Purpose::layer: return "the static layer";
    case Purpose::effects: return "effects";
    case Purpose::sorting: return "sorting";
    case Purpose::depth_bounds: return "bounds of depth";
  }
  return "unknown";
}

}  // namespace zstrip
