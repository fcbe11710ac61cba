// Everything that an application includes.
#pragma once

#include "zstrip/base/math.hpp"
#include "zstrip/base/status.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip/plan/plan.hpp"
#include "zstrip/plan/plan_depth.hpp"
#include "zstrip/scene/animation.hpp"
#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/effects.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip/scene/view.hpp"
#include "zstrip/store/depth_store.hpp"
#include "zstrip/visibility/visible_sets.hpp"
