// Every registered material with parameters that explore what its own list allows: the contract
// tests loop over these, so that a new material costs no new test.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "materials/material.h"

namespace karat::test {

struct MaterialCase {
  std::string name;  // "conductor distribution=beckmann alpha=0.25"
  std::shared_ptr<const Material> material;
};

// Built once. Index parameters get a dispersive, absorbing table for "nk" and a dispersive
// transparent one otherwise; each choice is combined with each bounded number.
const std::vector<MaterialCase>& material_cases();

// A material of type `type` with defaults from its own list and `values` on top.
std::shared_ptr<const Material> make_material(const std::string& type, const Parameters& values,
                                              std::vector<std::string>* warnings = nullptr,
                                              const std::string& fresnel_override = "");

}  // namespace karat::test
