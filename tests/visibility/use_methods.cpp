// Lets AnyRenderer draw by visibility methods before any test begins.
#include "zstrip/visibility.hpp"

namespace {
[[maybe_unused]] const bool kUsed = (zstrip::use_visibility_methods(), true);
}  // namespace
