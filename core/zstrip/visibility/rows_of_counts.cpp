// The pipelines that can count and cull, without another method.
#include "zstrip/visibility/make_rows.hpp"

namespace zstrip {

void use_overdraw_counts() {
  static constexpr auto kRows = detail::rows_with<Effects{}>();
  detail::further_rows[0] = {};
  detail::further_rows[1] = kRows;
}

}  // namespace zstrip
