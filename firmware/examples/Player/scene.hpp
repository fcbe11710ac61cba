// A scene for zstrip, baked from block.obj: 12 triangles in 1 meshlet, 1 instance.
// Written by `zstrip bake`: do not edit, bake again. The camera is placed for 240x240 pixels, rgb565_swapped.
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
// begin_frame and draw_strip return a Status: check it. To move the scene, change the transforms of
// `moving.instances()`, with baked::FixedRenderer::Moving moving, and call begin_frame(kCamera, moving).
// Only the baked motion is known to need no clipping: see kEffects.
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
    {.x = 3260, .y = 26084, .z = 19563, .colour = {151, 151, 151, 255}}};

inline constexpr zstrip::Scene kScene{.meshes = kMeshes,
                                      .materials = kMaterials,
                                      .textures = {},
                                      .instances = kInstances,
                                      .lights = kLights,
                                      .ambient = {104, 104, 104, 255},
                                      .background = {206, 211, 214, 255}};

/// The motion of the instances, if it has tracks. Times in milliseconds.
inline constexpr zstrip::Animation kAnimation{.tracks = {}, .keyframes = {}, .duration = 0};
/// The motion of a scene without tracks, if several frames are shown.
inline constexpr zstrip::Turn kTurn{.what = zstrip::Turning::instances_and_lines, .still_instances = 0};

inline constexpr zstrip::Camera kCamera{.right = {929904853, 0, -536841194},  // 2.30
                                        .up = {-183615876, 1008983356, -318055499},
                                        .back = {504463752, 367252081, 873821339},
                                        .eye = {198342, 127795, 343565},  // 16.16, like the members below
                                        .focal = 244599,
                                        .near_plane = 272943,
                                        .far_plane = 589880,
                                        .projection = zstrip::Projection::perspective,
                                        .fixed_depth_range = false};

/// The picture of camera and plan.
inline constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
/// All effects that the scene needs: instantiate one pipeline, with these.
/// No code for clipping is linked. The boxes of all instances stay between the near and the far plane and within a
/// thousand pixels of the picture's centre, in any pose of a rotation.
/// If the program moves camera or instances in another way and a box leaves this range, begin_frame returns
/// Error::clipping; then bake with --clipping on.
inline constexpr zstrip::Effects kEffects = zstrip::effect::lighting | zstrip::effect::gouraud | zstrip::effect::unclipped | zstrip::effect::shade_gouraud;
static_assert(kEffects == (zstrip::effects_of(kScene, kCamera) | zstrip::effect::unclipped));
inline constexpr zstrip::SceneCounts kCounts = zstrip::count(kScene);
/// The limits of --ram and other options, and the strips that fit them: 11,976 bytes of arena and 11,520 for
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
/// Draws kScene in kView: scene, picture and plan are constants that the compiler has checked.
using FixedRenderer = zstrip::FixedRenderer<kScene, kView, kBudget, zstrip::effect::unclipped,
                                            zstrip::Projection::perspective, kCounts>;

}  // namespace baked
