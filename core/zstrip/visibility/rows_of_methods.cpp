// The pipelines with a visibility method.
#include "zstrip/visibility/make_rows.hpp"

namespace zstrip {

void use_visibility_methods() {
  /// The first one has only culling.
  static constexpr auto kRows =
      detail::rows_with<Effects{}, method::painter, method::painter | method::in_order, method::painter | method::bsp,
                        method::front_to_back, method::hierarchical_z, method::front_to_back | method::hierarchical_z,
                        method::midpoint, method::midpoint_safe>();
  detail::further_rows[0] = detail::rows_of_measured_methods();
  detail::further_rows[1] = kRows;
}

}  // namespace zstrip
