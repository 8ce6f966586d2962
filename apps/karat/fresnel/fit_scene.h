// Fitted parameters of a Fresnel model, written into a scene.
#pragma once

#include <string>
#include <vector>

#include "materials/fresnel_study/fresnel_fit_material.h"

namespace karat {

struct FitScene {
  std::string input, output;  // files; the same one is replaced when the new one is whole
  std::string page;           // conductors whose "nk" is this,
  std::string material;       // or the one of this name, where it is not empty
};

// Returns the names of the materials that now use `model` with the fitted values. Throws InputError
// where the scene has none.
std::vector<std::string> write_fit_to_scene(const FitScene& place, const std::string& model,
                                            const FresnelFits& fits);

}  // namespace karat
