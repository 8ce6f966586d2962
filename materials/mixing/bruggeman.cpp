// Grains of all parts side by side, none of them the host: the medium is the one in which they
// polarise nothing on average,
//   sum f_i (eps_i - eps) / (eps_i + 2 eps) = 0,
// Bruggeman, Ann. Phys. (Leipzig) 416, 636-664 (1935). For N parts it has N roots.
//
// Which root. Because (eps_i - eps) / (eps_i + 2 eps) = 1 - 3 eps / (eps_i + 2 eps), the equation
// is
//   eps = F(eps),  F(w) = 1 / (3 sum f_i / (eps_i + 2 w)).
// If all eps_i lie in a half-plane whose edge passes through 0, F maps the half-plane into itself.
// By Schwarz and Pick such a map has at most one fixed point inside, where |F'| < 1, and iterating
// it leads there. Passive parts lie in the upper half-plane; we take the half-plane in whose middle
// they lie, which is the same root, farther from the edge. So the root is unique, and as continuous
// in wavelength as the parts are: no branch is ever chosen. Newton's steps are taken where they
// stay inside and come nearer, else F's own.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "materials/mixing_rule.h"

namespace karat {
namespace {

struct Step {
  Permittivity value;  // F(w)
  Permittivity slope;  // F'(w)
};

Step step(std::span<const MixingPart> parts, Permittivity w) {
  Permittivity sum = 0.0, squares = 0.0;
  for (const MixingPart& part : parts) {
    const Permittivity inverse = 1.0 / (part.permittivity + 2.0 * w);
    sum += part.fraction * inverse;
    squares += part.fraction * inverse * inverse;
  }
  return {1.0 / (3.0 * sum), 2.0 * squares / (3.0 * sum * sum)};
}

// Turns the parts so that they lie about the imaginary axis; returns what turns back.
Permittivity turn_upright(std::vector<MixingPart>& parts) {
  double least = std::numbers::pi, largest = 0.0;
  for (const MixingPart& part : parts) {
    if (part.permittivity == 0.0) continue;
    least = std::min(least, std::arg(part.permittivity));
    largest = std::max(largest, std::arg(part.permittivity));
  }
  const double angle = 0.5 * (std::numbers::pi - least - largest);
  for (MixingPart& part : parts) part.permittivity *= std::polar(1.0, angle);
  return std::polar(1.0, -angle);
}

Permittivity fixed_point(std::span<const MixingPart> parts) {
  constexpr int kMostSteps = 500;
  constexpr double kResolution = 4e-16;
  Permittivity w = 0.0;
  for (const MixingPart& part : parts) {
    w += part.fraction * (part.permittivity + Permittivity(0.0, 0.1 * std::abs(part.permittivity)));
  }
  Step at = step(parts, w);
  for (int i = 0; i < kMostSteps; ++i) {
    const double error = std::abs(at.value - w);
    const bool attracts = std::abs(at.slope) <= 1.0 + 1e-6;
    if (error <= kResolution * std::abs(w) && attracts) break;
    Permittivity next = w - (at.value - w) / (at.slope - 1.0);
    Step then = step(parts, next);
    const bool nearer = next.imag() > 0.0 && std::abs(then.value - next) < error && attracts;
    if (!nearer) {
      // Within the last bits neither is nearer; outside of them F's own step always is.
      if (error <= 8.0 * kResolution * std::abs(w) && attracts) break;
      next = at.value;
      then = step(parts, next);
    }
    w = next;
    at = then;
  }
  return w;
}

class Bruggeman final : public MixingRule {
 public:
  std::string description() const override {
    return "grains side by side, no host: sum f_i (eps_i - eps)/(eps_i + 2 eps) = 0";
  }
  std::string source() const override {
    return "Bruggeman, Ann. Phys. (Leipzig) 416, 636-664 (1935)";
  }

  Permittivity mixed(std::span<const MixingPart> parts, std::size_t) const override {
    std::vector<MixingPart> upright;
    for (const MixingPart& part : parts) {
      if (part.fraction > 0.0) upright.push_back(part);
    }
    if (upright.size() == 1) return upright.front().permittivity;
    const Permittivity back = turn_upright(upright);
    const Permittivity result = fixed_point(upright) * back;
    return {result.real(), std::max(result.imag(), 0.0)};
  }
};

KARAT_REGISTER(MixingRule, "bruggeman", Bruggeman);

}  // namespace
}  // namespace karat
