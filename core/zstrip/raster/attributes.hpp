// Loads the attributes of a triangle's vertices that its shade needs: colours and texture coordinates.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/effects.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

/// A meshlet with transformed vertices, ready to be drawn into a strip.
struct Batch {
  const CompiledInstance* instance;
  const Mesh* mesh;
  const SnappedVertex* vertices;  ///< begins with the mesh's vertex first_vertex
  const Colour* colours;          ///< in the same order; null if no vertex has its own colour
  std::uint32_t first_vertex;
  RasterOrigin origin;
  Surface surface;
};

/// The batch of a renderer with effect::environment.
struct ReflectingBatch : Batch {
  TexCoord* reflections;  ///< in the same order, with 15 fraction bits; null if the mesh's own texture coordinates are
                          ///< used
};

template <Effects effects>
using BatchOf = std::conditional_t<effects.has(effect::environment), ReflectingBatch, Batch>;

/// Converts a texture coordinate to texels, 16.16.
constexpr std::int32_t texels(std::int16_t coordinate, std::uint8_t log2_size, std::uint8_t fraction_bits) {
  const int shift = 16 + log2_size - fraction_bits;  // 1 .. 23
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::int32_t{coordinate}) << shift);
}

template <Effects effects>
struct VertexAttributes {
  static constexpr bool kTextures = effects.has(effect::textures);
  static constexpr bool kColours = has_vertex_colours(effects);
  using Batch = BatchOf<effects>;

  /// Loads colour and texture coordinates if `shade` reads them.
  template <Shade shade, class Vertex>
  static void load(const Batch& batch, std::uint32_t index, Vertex& vertex) {
    if constexpr (shade == Shade::gouraud || shade == Shade::textured_gouraud || shade == Shade::textured_flat) {
      set_colour(vertex, colour_of(batch, index));
    }
    if constexpr (shade == Shade::fragments) {
      const Shade kind = without_fragments(batch.instance->shade);
      const bool white = kind == Shade::textured;  // texels are not multiplied
      set_colour(vertex, white ? Colour{255, 255, 255, 255} : colour_of(batch, index));
      if (!kTextures || kind < Shade::textured) return;
    }
    if constexpr (shade >= Shade::textured && kTextures) load_texture_coordinates(batch, index, vertex);
  }
  template <class Vertex>
  static void load_texture_coordinates(const Batch& batch, std::uint32_t index, Vertex& vertex) {
    if constexpr (effects.has(effect::environment)) {
      if (batch.reflections != nullptr) {
        const TexCoord& t = batch.reflections[index - batch.first_vertex];
        vertex.u = texels(t.u, batch.surface.texture.log2_width, 15);
        vertex.v = texels(t.v, batch.surface.texture.log2_height, 15);
        return;
      }
    }
    const TexCoord& t = batch.mesh->texcoords[index];
    vertex.u = texels(t.u, batch.surface.texture.log2_width, batch.mesh->texcoord_bits);
    vertex.v = texels(t.v, batch.surface.texture.log2_height, batch.mesh->texcoord_bits);
  }

  /// Returns the colour of the triangle's first vertex; clipping and culling may change the vertices' order.
  template <Shade shade>
  static std::uint16_t flat_colour(const Batch& batch, const Triangle& triangle) {
    if constexpr (shade == Shade::flat && kColours) {
      if (batch.colours != nullptr) return rgb565(batch.colours[triangle.a - batch.first_vertex]);
    }
    return batch.surface.flat_colour;
  }

  /// Gives all vertices the colour of the first one, for flat shades.
  template <Shade shade>
  static void take_first_colour(const Batch& batch, const Triangle& provoking, RasterVertex (&vertices)[3]) {
    if constexpr (shade != Shade::textured_flat && shade != Shade::fragments) return;
    const Shade kind = without_fragments(batch.instance->shade);
    if (kind != Shade::flat && kind != Shade::textured_flat) return;
    for (RasterVertex& vertex : vertices) set_colour(vertex, colour_of(batch, provoking.a));
  }

  static const Colour& colour_of(const Batch& batch, std::uint32_t index) {
    if constexpr (kColours) {
      if (batch.colours != nullptr) return batch.colours[index - batch.first_vertex];
    }
    return batch.instance->base;
  }

 private:
  template <class Vertex>
  static void set_colour(Vertex& vertex, const Colour& colour) {
    vertex.r = channel_start(colour.r);
    vertex.g = channel_start(colour.g);
    vertex.b = channel_start(colour.b);
  }
};

}  // namespace zstrip::detail
