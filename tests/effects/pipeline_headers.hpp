// What the programs for absence_test.cpp include, parsed once for all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "billboards_scene.hpp"
#include "csg_scene.hpp"
#include "edges_scene.hpp"
#include "lines_scene.hpp"
#include "outlines_scene.hpp"
#include "overlay_scene.hpp"
#include "shadows_scene.hpp"
#include "zstrip/visibility.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"
