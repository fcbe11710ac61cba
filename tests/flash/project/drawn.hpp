// What the minimal programs draw: FLASH_SCENE, a scene of the catalogue, in 320x240 pixels and strips of 8 rows.
#pragma once

#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"

namespace {

constexpr zstrip::Scene kScene = zstrip::scenes::FLASH_SCENE.scene;
constexpr zstrip::SceneCounts kCounts = zstrip::scenes::FLASH_SCENE.counts;
constexpr zstrip::View kView{320, 240, zstrip::PixelFormat::rgb565};
constexpr zstrip::Budget kBudget{.strip_rows = 8};

/// The compiler takes it for changed.
template <class Value>
void learn_at_run_time(Value& value) {
  asm volatile("" : "+m"(value) : : "memory");
}

}  // namespace
