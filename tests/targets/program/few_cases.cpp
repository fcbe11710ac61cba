// A few of the cases, of scenes that compile quickly: three that run every kernel, and blending.
#include <iterator>

#include "subjects.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/room.hpp"

namespace zstrip::targets {

bool for_each_case(bool (*run)(const Case&)) {
  constexpr const Subject* kSubjects[] = {&kSubject<scenes::cube>, &kSubject<scenes::room>, &kSubject<scenes::knot>};
  constexpr const Subject* kEffectSubjects[] = {&kSubject<scenes::blend>};
  return in_views(kSubjects, std::size(kViews), run) && in_views(kEffectSubjects, 1, run);
}

}  // namespace zstrip::targets
