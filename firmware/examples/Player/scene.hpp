// A scene for zstrip, baked from block.obj: 12 triangles in 1 meshlet, 1 instance.
// Written by `zstrip bake`: bake again rather than edit. Placed for 240x240 pixels, rgb565_swapped.
//
//     #include "zstrip/zstrip.hpp"
//     alignas(4) std::array<std::byte, baked::FixedRenderer::kStripBytes> pixels;
//     baked::FixedRenderer renderer;  // its arena is in it
//
//     renderer.begin_frame(baked::kCamera);
//     for (std::uint16_t strip = 0; strip < baked::kPlan.strips; ++strip) {
//       renderer.draw_strip(strip, pixels);
//       // baked::kPlan.strip_area(strip, baked::kView) of the picture is in `pixels`: send it to the display.
//     }
//
// begin_frame and draw_strip return a Status: look at it. To move the scene, change the transforms of
// `baked::FixedRenderer::Moving moving`, its instances(), and begin the frame with kCamera, moving.
// Motions other than the one that was baked may need clipping: see kEffects.
#pragma once

#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace baked {

inline constexpr zstrip::Position kPositions0[24] = {
    {-32767, -32767, -32767}, {-32767, 32767, -32767}, {32767, 32767, -32767}, {32767, -32767, -32767},
    {-32767, -32767, -32767}, {-32767, 32767, 32767}, {-32767, 32767, -32767}, {-32767, -32767, 32767},
    {-32767, -32767, -32767}, {32767, -32767, 32767}, {-32767, -32767, 32767}, {32767, -32767, -32767},
    {-32767, -32767, 32767}, {32767, 32767, 32767}, {-32767, 32767, 32767}, {32767, -32767, 32767},
    {-32767, 32767, -32767}, {-32767, 32767, 32767}, {32767, 32767, 32767}, {32767, 32767, -32767},
    {32767, -32767, -32767}, {32767, 32767, 32767}, {32767, -32767, 32767}, {32767, 32767, -32767}};
inline constexpr zstrip::Normal kNormals0[24] = {
    {0, 0, -127, 0}, {0, 0, -127, 0}, {0, 0, -127, 0}, {0, 0, -127, 0}, {-127, 0, 0, 0}, {-127, 0, 0, 0},
    {-127, 0, 0, 0}, {-127, 0, 0, 0}, {0, -127, 0, 0}, {0, -127, 0, 0}, {0, -127, 0, 0}, {0, -127, 0, 0},
    {0, 0, 127, 0}, {0, 0, 127, 0}, {0, 0, 127, 0}, {0, 0, 127, 0}, {0, 127, 0, 0}, {0, 127, 0, 0}, {0, 127, 0, 0},
    {0, 127, 0, 0}, {127, 0, 0, 0}, {127, 0, 0, 0}, {127, 0, 0, 0}, {127, 0, 0, 0}};
inline constexpr zstrip::Triangle kTriangles0[12] = {
    {0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 7, 5}, {8, 9, 10}, {8, 11, 9}, {12, 13, 14}, {12, 15, 13}, {16, 17, 18},
    {16, 18, 19}, {20, 21, 22}, {20, 23, 21}};
inline constexpr zstrip::Meshlet kMeshlets0[1] = {
    {0, 0, 24, 12, 56755, {0, 0, 0}}};

inline constexpr zstrip::Mesh kMeshes[1] = {
    {.positions = kPositions0,
     .normals = kNormals0,
     .colours = {},
     .texcoords = {},
     .triangles = kTriangles0,
     .meshlets = kMeshlets0,
     .centre = {0, 0, 0},
     .half_extent = {65539, 65539, 65539},
     .texcoord_bits = 12},
};
inline constexpr zstrip::Material kMaterials[1] = {
    {.colour = {204, 204, 204, 255}, .lit = true, .smooth = true, .double_sided = false}};
inline constexpr zstrip::Instance kInstances[1] = {
    {.mesh = 0, .material = 0, .transform = {{{65536, 0, 0, 0}, {0, 65536, 0, 0}, {0, 0, 65536, 0}}}}};
inline constexpr zstrip::DirectionalLight kLights[1] = {
    {.x = -15621, .y = 21869, .z = 18745, .colour = {207, 207, 207, 255}}};

inline constexpr zstrip::Scene kScene{.meshes = kMeshes,
                                      .materials = kMaterials,
                                      .textures = {},
                                      .instances = kInstances,
                                      .lights = kLights,
                                      .ambient = {48, 48, 48, 255},
                                      .background = {0, 0, 0, 255}};

/// What moves the instances, if it has tracks. Times in milliseconds.
inline constexpr zstrip::Animation kAnimation{.tracks = {}, .keyframes = {}, .duration = 0};
/// What moves without one, where several frames are shown.
inline constexpr zstrip::Turn kTurn{.what = zstrip::Turning::instances_and_lines, .still_instances = 0};

inline constexpr zstrip::Camera kCamera{.right = {1073741824, 0, 0},  // 2.30
                                        .up = {0, 1008983356, -367252081},
                                        .back = {0, 367252081, 1008983356},
                                        .eye = {0, 120243, 378491},  // 16.16, as all below
                                        .focal = 244599,
                                        .near_plane = 255257,
                                        .far_plane = 568264,
                                        .projection = zstrip::Projection::perspective,
                                        .fixed_depth_range = false};

/// The picture that camera and plan are for.
inline constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
/// All that the scene calls for: the one pipeline to instantiate.
/// No clipping is linked. It was checked that the box of no instance crosses the near or the far plane, or leaves the
/// thousand pixels around the picture's centre, in any pose of a turn.
/// A frame in which one does, because the program moves camera or instances otherwise, is Error::clipping: for that,
/// bake with --clipping on.
inline constexpr zstrip::Effects kEffects = zstrip::effect::lighting | zstrip::effect::gouraud | zstrip::effect::unclipped | zstrip::effect::shade_gouraud;
static_assert(kEffects == (zstrip::effects_of(kScene, kCamera) | zstrip::effect::unclipped));
inline constexpr zstrip::SceneCounts kCounts = zstrip::count(kScene);
/// What --ram and the other options allowed, and the strips that were chosen for it: 11,976 bytes of arena and 11,520 for
/// each of 1 strip buffer.
inline constexpr zstrip::Budget kBudget{.bytes = 24576,
                                        .strip_rows = 24,
                                        .strip_columns = 240,
                                        .split_columns = false,
                                        .strip_buffers = 1,
                                        .modes = zstrip::Modes::streamed};
inline constexpr zstrip::PlanResult kPlanned = zstrip::plan(kCounts, kView, kEffects, kBudget);
static_assert(kPlanned.status, "the picture does not fit the bytes of kBudget");
inline constexpr zstrip::Plan kPlan = kPlanned.plan;
/// Draws kScene in kView: scene, picture and plan are constants, which the compiler has checked.
using FixedRenderer = zstrip::FixedRenderer<kScene, kView, kBudget, zstrip::effect::unclipped,
                                            zstrip::Projection::perspective, kCounts>;

}  // namespace baked
