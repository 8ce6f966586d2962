// The Fresnel model that computes nothing.
#pragma once

#include "materials/fresnel.h"

namespace karat {

// Returns what stands in its tables: what is left of a model's time is the call and the loop around
// it. Not registered. Lives in a file of its own, so that no compiler takes the call for granted.
const FresnelModel& empty_fresnel_model();

}  // namespace karat
