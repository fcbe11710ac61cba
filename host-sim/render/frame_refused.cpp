// Maps a refusal of the renderer to an exit status by its cause; see frame_refused.hpp.
#include "render/frame_refused.hpp"

#include <fmt/format.h>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

ExitStatus fault_of(Error error) {
  switch (error) {
    case Error::camera:
    case Error::instance: return ExitStatus::input;
    case Error::arena_too_small: return ExitStatus::budget;
    default: return ExitStatus::internal;
  }
}

}  // namespace

Failure frame_refused(std::string_view what, const Status& status) {
  // The only store in a frame's own memory is the store of a shadow's map.
  if (status.error == Error::store_full && status.purpose == Purpose::effects) {
    return {
        ExitStatus::budget,
        fmt::format("{}: the shadow's map does not fit into its pool of {}; give the key 'pool' of the light's shadow "
                    "more, or leave it out for the worst case, or take a smaller 'size'",
                    what, counted(status.available, "byte"))};
  }
  return {fault_of(status.error), fmt::format("{}: {} (needed {}, available {})", what, message(status.error),
                                              status.needed, status.available)};
}

}  // namespace zstrip::sim
