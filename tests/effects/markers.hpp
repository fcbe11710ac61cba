// Symbols that are an effect's own. A program that is compiled without inlining has them where it has the effect, and
// no program has them without. The stages of fragments are in one object: only a linker with sections, that of boards,
// leaves some of them out.
#pragma once

#include "zstrip/visibility.hpp"

namespace effects_test {

using namespace zstrip;

struct Marker {
  Effects effects;  ///< a program that has none of them has no symbol with this in its name
  const char* symbol;
};
inline constexpr Marker kMarkers[] = {
    {{}, "zstrip::skin_mesh("},  // no effect of a renderer: of no program here
    {{}, "zstrip::morph_mesh("},
    {effect::fog, "zstrip::detail::fog_curve("},
    {effect::fog, "zstrip::detail::visibility("},
    {effect::fog, "zstrip::detail::power_of_half("},
    {effect::fog, "zstrip::detail::FogPlane<"},
    {effect::vertex_light, "zstrip::detail::locally_lit_colour<"},
    {effect::local_light, "zstrip::detail::frame_lights("},
    {effect::local_light, "zstrip::detail::instance_shading("},
    {effect::local_light | effect::environment, "zstrip::detail::direction_of("},
    {effect::punctual_lights, "zstrip::detail::attenuation("},
    {effect::specular, "zstrip::detail::power("},
    {effect::fragments, "zstrip::detail::fill_fragments<"},
    {effect::fragments, "zstrip::detail::draw_fragment_run<"},
    {effect::fragments, "draw_fragment_triangle"},  // whose name binutils cannot demangle
    {effect::blending, "zstrip::detail::blending::prepare("},
    {effect::mipmaps, "zstrip::detail::level_of("},
    {effect::mipmaps, "zstrip::detail::level_of_run("},
    {effect::mipmaps, "::footprint_at("},
    {effect::textures, "zstrip::detail::TextureCoordinates<"},
    {effect::lighting, "zstrip::detail::lit_colour("},
    {effect::quadrics, "zstrip::detail::QuadricFill<"},
    {effect::lines, "zstrip::detail::LineFill<"},
    {effect::lines | effect::edges, "zstrip::detail::clip_segment<"},
    {effect::lines, "zstrip::detail::lines::prepare("},
    {effect::billboards, "zstrip::detail::billboards::turn("},
    {effect::billboards, "zstrip::detail::turned_to_viewer("},
    {effect::environment, "zstrip::detail::environment::prepare("},
    {effect::environment, "zstrip::detail::eye_forms("},
    {effect::environment, "zstrip::detail::MirroredPoint"},
    {effect::pixel_shading, "zstrip::detail::pixel_shading::prepare("},
    {effect::pixel_shading, "zstrip::detail::PixelLight<"},
    {effect::pixel_shading, "zstrip::detail::lit_corner<"},
    {effect::pixel_shading, "zstrip::detail::pixel_direction_of("},
    {effect::outlines, "zstrip::detail::outlines::add_hulls("},
    {effect::outlines, "zstrip::detail::make_outline("},
    {effect::outlines, "zstrip::detail::transform_hull<"},
    {effect::shadows, "zstrip::detail::shadows::Stage::"},
    {effect::shadows, "zstrip::detail::light_camera("},
    {effect::shadows, "zstrip::detail::shadow_place("},
    {effect::shadows, "zstrip::detail::TileStore::"},
    {effect::csg, "zstrip::detail::csg::Stage::"},
    {effect::csg, "zstrip::detail::DepthMode{(zstrip::DepthFormat)0, false, (zstrip::detail::DepthUse)3"},
    {effect::edges, "zstrip::detail::edges::Stage::"},
    {effect::edges, "zstrip::detail::EdgeBlend<"},
    {effect::edges, "zstrip::detail::blended("},
    {effect::overlay, "zstrip::draw_overlay("},
    {effect::overlay, "zstrip::detail::overlay::Stage::"},
    {effect::bins, "zstrip::detail::Bins::append("},
    {effect::shade_flat | effect::shadows | effect::csg, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)0"},
    {effect::gouraud, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)1"},
    {effect::gouraud, "::draw_narrow_spans<(zstrip::detail::Shade)1"},  // where the one above is inlined
    {effect::shade_textured, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)2"},
    {effect::shade_textured_flat, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)3"},
    {effect::shade_textured_gouraud, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)4"},
    {effect::unclipped, "zstrip::detail::unclipped::"},
    {effect::skins, "zstrip::detail::skins::"},
    {effect::skins, "zstrip::detail::move_positions("},
    {effect::vertex_colours | effect::lighting, "::shade_vertices"},
    {effect::orthographic | effect::shadows, "zstrip::detail::draw_span_triangle<(zstrip::detail::Shade)0, true"},
    {effect::statistics, ", true, zstrip::detail::DepthMode{"},
    {effect::depth_state | effect::shadows, "zstrip::detail::DepthMode{(zstrip::DepthFormat)0, true"},
    {effect::depth_float, "zstrip::detail::DepthMode{(zstrip::DepthFormat)1"},
    {effect::depth_24, "zstrip::detail::DepthMode{(zstrip::DepthFormat)2"},
    {effect::depth_ranges, "zstrip::detail::depth_mapping_of_ranges("},
    {effect::perspective_affine, "}, 0l, "},
    {effect::perspective_8, "}, 8l, "},
    {effect::perspective_1, "}, 1l, "},
    {method::sorted, "MethodStage::collect_triangles"},
    {method::painter, "(zstrip::detail::DepthUse)2"},
    {method::in_order, "(zstrip::detail::DepthUse)2, 33u"},
    {method::hierarchical_z | method::midpoint_safe, "zstrip::detail::DepthBounds::level_hides("},
    {method::midpoint | method::midpoint_safe, "zstrip::detail::MidpointSplitter<"},
    {method::culling, "MethodStage::is_left_out("},
    {effect::dithered_colours | effect::dithered_format, "zstrip::detail::kBayer"},
    {effect::dithered_format, "zstrip::dither_pixels("},
    {effect::supersampled, "zstrip::detail::samples::Stage::"},
    {effect::supersampled, "zstrip::detail::average_samples<false>("},
    {effect::supersampled, "zstrip::detail::camera_of_samples("},
};

}  // namespace effects_test
