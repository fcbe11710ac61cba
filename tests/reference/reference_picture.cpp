// See reference_picture.hpp.
#include "reference_picture.hpp"

namespace zstrip::reference {

sim::Result<ReferencePicture> draw_reference(const sim::Staging& staging, const View& view, float drift) {
  const auto canvas = Canvas::open(view);
  if (!canvas) return canvas.failure();
  ReferencePicture picture{view, geometry_of(staging.scene, staging.camera, view), {}, {}};
  (*canvas)->load(picture.geometry, staging.scene);
  constexpr std::array<Offset, 9> kOffsets{Offset{0, 0},      {-kReach, -kReach}, {0, -kReach},
                                           {kReach, -kReach}, {-kReach, 0},       {kReach, 0},
                                           {-kReach, kReach}, {0, kReach},        {kReach, kReach}};
  for (std::size_t i = 0; i < kOffsets.size(); ++i) {
    picture.layers[i] = (*canvas)->draw_layers(kOffsets[i], kDepthTolerance);
  }
  for (int step = 2; static_cast<float>(step) * kReach <= drift; ++step) {
    for (const int direction : {-step, step}) {
      for (const float y : {-kReach, 0.0F, kReach}) {
        picture.drifts.push_back((*canvas)->draw({static_cast<float>(direction) * kReach, y}));
      }
    }
  }
  return picture;
}

}  // namespace zstrip::reference
