// Of visibility methods the larger module has only what counts how often pixels are drawn.
#include "zstrip/visibility.hpp"

namespace {
[[maybe_unused]] const bool kCounts = (zstrip::use_overdraw_counts(), true);
}  // namespace
