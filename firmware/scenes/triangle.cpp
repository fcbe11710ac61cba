// The data of the single triangle.
#include "zstrip_scenes/triangle.hpp"

#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {

constexpr Position kTrianglePositions[3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
constexpr Colour kTriangleColours[3] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
constexpr Triangle kTriangleTriangles[1] = {{0, 1, 2}};

static_assert(validate(triangle.scene));

}  // namespace zstrip::scenes
