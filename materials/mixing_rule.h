// Effective-medium rules: the permittivity of a mixture whose grains are small against wavelength.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <string>

#include "spectral/support/registry.h"

namespace karat {

// Relative permittivity (n + ik)^2; the imaginary part is not negative: exp(-i omega t).
using Permittivity = std::complex<double>;

struct MixingPart {
  double fraction;  // by volume; the fractions of a mixture sum to 1
  Permittivity permittivity;
};

// Stateless and shared. One source file per rule, ending in
//   KARAT_REGISTER(MixingRule, "bruggeman", Bruggeman);
class MixingRule {
 public:
  virtual ~MixingRule() = default;

  // One sentence, the paper, and the equation.
  virtual std::string description() const = 0;
  virtual std::string source() const = 0;

  // Whether one part is the host that holds the grains of all the others.
  virtual bool has_host() const { return false; }

  // `host` is an index of `parts`, and counts for rules that have a host. The imaginary part of the
  // result is not negative where those of the parts are not. A part alone gives itself.
  virtual Permittivity mixed(std::span<const MixingPart> parts, std::size_t host) const = 0;
};

}  // namespace karat
