// The list of the effects' scenes.
#include "zstrip_scenes/effect_scenes.hpp"

namespace zstrip::scenes {
namespace {

constexpr BuiltIn kEffectScenes[] = {fog};

}  // namespace

std::span<const BuiltIn> effect_scenes() { return kEffectScenes; }

}  // namespace zstrip::scenes
