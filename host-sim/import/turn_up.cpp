// The rotation that makes an axis of a model point upwards.
#include "import/turn_up.hpp"

namespace zstrip::sim {

Affine turn_up(UpAxis up) {
  // clang-format off
  switch (up) {
    case UpAxis::plus_x:  return {{{{ 0, -1, 0, 0}, { 1,  0,  0, 0}, {0,  0, 1, 0}}}};
    case UpAxis::minus_x: return {{{{ 0,  1, 0, 0}, {-1,  0,  0, 0}, {0,  0, 1, 0}}}};
    case UpAxis::plus_y:  return {};
    case UpAxis::minus_y: return {{{{-1,  0, 0, 0}, { 0, -1,  0, 0}, {0,  0, 1, 0}}}};
    case UpAxis::plus_z:  return {{{{ 1,  0, 0, 0}, { 0,  0,  1, 0}, {0, -1, 0, 0}}}};
    case UpAxis::minus_z: return {{{{ 1,  0, 0, 0}, { 0,  0, -1, 0}, {0,  1, 0, 0}}}};
  }
  // clang-format on
  return {};
}

}  // namespace zstrip::sim
