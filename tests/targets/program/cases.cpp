// Every kind of scene in every picture format and three strip heights; each effect's scene in three strip heights; then
// frames that stand for more: benchmark workloads, swapped bytes, a camera inside a room that turns all the way around.
#include "cases.hpp"

#include <iterator>

#include "subjects.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/teapot.hpp"
#include "zstrip_scenes/triangle.hpp"

namespace zstrip::targets {
namespace {

// The other depth formats: those for use in a room, where every octave and clipping occur; those for comparison with
// large triangles.
constexpr Subject kRoomFloat{&scenes::room, draw_case<scenes::room, effect::depth_float | effect::depth_state>,
                             "_float"};
constexpr Subject kRoomRanges{&scenes::room, draw_case<scenes::room, effect::depth_ranges>, "_ranges"};
constexpr Subject kRandom50Of24{&scenes::random50, draw_case<scenes::random50, effect::depth_24>, "_z24"};

constexpr const Subject* kTriangle = &kSubject<scenes::triangle>;
constexpr const Subject* kCube = &kSubject<scenes::cube>;
constexpr const Subject* kRoom = &kSubject<scenes::room>;
constexpr const Subject* kRandom50 = &kSubject<scenes::random50>;
constexpr const Subject* kTeapot = &kSubject<scenes::teapot>;
constexpr const Subject* kKnot = &kSubject<scenes::knot>;
constexpr const Subject* kKnotFlat = &kSubject<scenes::knot_flat>;
constexpr const Subject* kKnotTextured = &kSubject<scenes::knot_textured>;
constexpr const Subject* kRandom10k = &kSubject<scenes::random10k>;
constexpr const Subject* kRandom10kMeshlets = &kSubject<scenes::random10k_meshlets>;

constexpr const Subject* kSubjects[] = {kTriangle, kCube,     kRoom,         kRandom50, kTeapot,
                                        kKnot,     kKnotFlat, kKnotTextured, kRandom10k};
constexpr const Subject* kEffectSubjects[] = {
    &kSubject<scenes::fog>,      &kSubject<scenes::emissive>,    &kSubject<scenes::specular>,
    &kSubject<scenes::punctual>, &kSubject<scenes::mask>,        &kSubject<scenes::blend>,
    &kSubject<scenes::bilinear>, &kSubject<scenes::palette>,     &kSubject<scenes::spheres>,
    &kSubject<scenes::mipmaps>,  &kSubject<scenes::environment>, &kSubject<scenes::per_pixel>};

constexpr View kSmall{64, 48, PixelFormat::rgb565};
constexpr View kTiny{1, 1, PixelFormat::rgb565};
constexpr View kIcon{8, 8, PixelFormat::rgb565};  // all depth codes within a few rows
constexpr View kWide{160, 24, PixelFormat::rgb565_swapped};
constexpr View kTall{24, 100, PixelFormat::rgb565_swapped};
constexpr Case kSingleCases[] = {
    {kKnot, Motion::workload, {96, 72, PixelFormat::rgb565}, 16, 7, 2},
    {kCube, Motion::workload, {96, 72, PixelFormat::rgb565}, 16, 7, 2},
    {kRandom50, Motion::workload, {96, 72, PixelFormat::rgb565}, 16, 7, 2},
    {&kSubject<scenes::character>, Motion::workload, {60, 80, PixelFormat::rgb565}, 16, 7, 3},
    {kRandom10kMeshlets, Motion::workload, {96, 72, PixelFormat::rgb565}, 16, 7, 1},
    {kRoom, Motion::turntable, kWide, 5, 77, 1},
    {kTeapot, Motion::turntable, kTall, 33, 77, 1},
    {kTriangle, Motion::turntable, kTiny, 1, 0, 1},
    {kTriangle, Motion::turntable, kIcon, 3, 0, 1},
    {kTeapot, Motion::turntable, kSmall, 13, 0, 100},
    {kRoom, Motion::turntable, kSmall, 13, 0, 100},
    {&kRoomFloat, Motion::turntable, kSmall, 13, 0, 20},
    {&kRoomRanges, Motion::turntable, kSmall, 13, 0, 20},
    {&kRandom50Of24, Motion::turntable, kSmall, 13, 0, 4},
};

}  // namespace

bool for_each_case(bool (*run)(const Case&)) {
  if (!in_views(kSubjects, std::size(kViews), run) || !in_views(kEffectSubjects, 1, run)) return false;
  for (const Case& single : kSingleCases) {
    if (!run(single)) return false;
  }
  return true;
}

}  // namespace zstrip::targets
