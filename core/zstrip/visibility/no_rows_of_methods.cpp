// In place of the pipelines with a visibility method: only those that can count and cull. A method is refused.
#include "zstrip/visibility.hpp"

namespace zstrip {

void use_visibility_methods() { use_overdraw_counts(); }

}  // namespace zstrip
