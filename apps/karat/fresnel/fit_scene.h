// Fitted parameters of a Fresnel model, written into a scene.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "materials/fresnel_study/fresnel_fit_material.h"

namespace karat {

// What is to be fitted, as far as a scene must agree with it.
struct PlannedFit {
  IndexTablePtr table;
  std::vector<double> wavelengths_nm;
  double n_exterior = 1.0;
  bool per_wavelength = true, over_range = false;  // over_range: asked for
};

// A scene that a fit can be written into: everything that can be wrong with it is found before the
// fit is made.
class FitScene {
 public:
  // The conductors of the scene file `input` whose "nk" is the planned table, or the one named
  // `material`, where that is not empty. Throws InputError where there is none, where its index or
  // exterior is not what the fit is for, or where the fit would leave wavelengths of the scene
  // without values.
  FitScene(const std::string& input, const std::string& material, const PlannedFit& plan);

  const std::vector<std::string>& materials() const { return materials_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  // The scene, in which the materials use `model` with the fitted values, is written to `output`,
  // whole or not at all. Throws RuntimeError.
  void write(const std::string& output, const std::string& model, const FresnelFits& fits);

 private:
  nlohmann::ordered_json scene_;
  std::vector<std::string> materials_, warnings_;
};

}  // namespace karat
