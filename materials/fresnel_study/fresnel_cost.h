// What evaluating a Fresnel model costs on this machine.
//
// Kernels take turns, one short batch each, in a new order every round: whatever else the machine
// does meets all of them alike. A kernel's cost is compared with that of "exact" in the same round.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/fresnel.h"

namespace karat {

// The middle of a sample and the quartiles around it.
struct CostSpread {
  double median = 0.0, lower = 0.0, upper = 0.0;
};

CostSpread cost_spread(std::vector<double> values);  // of at least one value

struct FresnelCost {
  std::string model;
  CostSpread ns;        // per call, which evaluates all wavelengths of a path at one angle
  CostSpread relative;  // to "exact" of the same round
};

struct FresnelCostOptions {
  int rounds = 201;
  int calls = 4096;  // in a batch
  std::function<void(int done, int total)> after_round;
};

// A batch of calls: evaluates the model once for every cosine and returns something that depends on
// all results.
using CostKernel = std::function<float(const std::vector<float>& cosines)>;
struct NamedCostKernel {
  std::string model;
  CostKernel run;
};

// Costs in the order of `kernels`, one of which is named "exact".
std::vector<FresnelCost> measure_costs(const std::vector<NamedCostKernel>& kernels,
                                       const FresnelCostOptions& options = {});

// The renderer's kernel, kLanes wavelengths a call, through the virtual call that rendering makes,
// prepared for `table` over 380 to 780 nm; "exact" is measured whether asked for or not. After the
// models comes one named "" that does nothing: what calling costs.
std::vector<FresnelCost> fresnel_costs(const std::vector<std::string>& models,
                                       const IndexTable& table,
                                       const FresnelCostOptions& options = {});

// The same for one wavelength a call: double precision, scalar, straight from n and k, with nothing
// prepared but fitted parameters; how a program without lanes and tables would evaluate the models.
std::vector<FresnelCost> fresnel_single_costs(const std::vector<std::string>& models,
                                              const IndexTable& table,
                                              const FresnelCostOptions& options = {});

// The processor by its own name, or "unknown processor".
std::string processor_name();
// The options that the models were compiled with, and the vector instructions these allow.
std::string compiler_flags();
std::string vector_instructions();

}  // namespace karat
