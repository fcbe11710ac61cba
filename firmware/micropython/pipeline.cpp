// The pipeline of the module, for the effects that the build names (ZSTRIP_EFFECTS of micropython.mk).
#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

constexpr zstrip::Effects kEffects = ZSTRIP_EFFECTS;

extern "C" {
extern const zstrip_pipeline zstrip_micropython_pipeline;
extern const zstrip_picker zstrip_micropython_picker;
constinit const zstrip_pipeline zstrip_micropython_pipeline{zstrip::drawn_with<kEffects>};
constinit const zstrip_picker zstrip_micropython_picker{zstrip::pick_with<kEffects>};
}
