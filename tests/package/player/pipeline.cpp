// What a program in C needs of C++: the code that draws scene.hpp.
#include <zstrip_player/c_pipeline.hpp>

#include "scene.hpp"

extern "C" const zstrip_pipeline* scene_pipeline();
const zstrip_pipeline* scene_pipeline() {
  static constexpr zstrip_pipeline pipeline{zstrip::drawn_with<baked::kEffects>};
  return &pipeline;
}
