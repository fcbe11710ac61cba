// Includes all public headers but pick.hpp, area.hpp and fingerprints.hpp, for few programs, and visibility.hpp.
#pragma once

#include "zstrip/animation.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip/layer.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"
