// What a rough surface of microfacets with Smith masking scatters in all, once, by integration over
// its facets in double precision. Shares no code with what it checks.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "tests/reference_fresnel.h"

namespace karat::facets {

struct Direction {
  double x, y, z;
};
inline double dot(Direction a, Direction b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Slope density and Lambda from the tangent of a direction, alpha isotropic.
struct Surface {
  std::string name;
  std::function<double(double r2)> slopes;       // density of slope / alpha, r2 its square
  std::function<double(double tangent)> lambda;  // of alpha tan(theta)
};

inline Surface ggx() {
  return {"ggx", [](double r2) { return 1.0 / (M_PI * (1.0 + r2) * (1.0 + r2)); },
          [](double t) { return 0.5 * (std::sqrt(1.0 + t * t) - 1.0); }};
}

inline Surface beckmann() {
  return {"beckmann", [](double r2) { return std::exp(-r2) / M_PI; },
          [](double t) {
            if (!(t > 0.0)) return 0.0;
            const double a = 1.0 / t;
            return 0.5 * (std::erf(a) - 1.0 + std::exp(-a * a) * t / std::sqrt(M_PI));
          }};
}

// Shares of the energy that arrives from one direction.
struct Scattered {
  double reflected, refracted;
};

// Each facet m shows w an area D(m) <w.m> / cos, of which F is reflected and 1 - F refracted; what
// leaves is not shadowed with probability G2 (reflection) or G1 (refraction, both sides apart).
inline Scattered integrate_facets(const Surface& surface, double alpha, Direction w, double eta,
                                  bool perfect) {
  const auto lambda = [&](Direction d) {
    return surface.lambda(alpha * std::hypot(d.x, d.y) / std::abs(d.z));
  };
  const double lambda_w = lambda(w);
  Scattered total{0.0, 0.0};
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) * 0.5 * M_PI / kSteps, r = std::tan(t);
    const double ring = surface.slopes(r * r) * r * (1.0 + r * r) * (0.5 * M_PI / kSteps);
    for (int j = 0; j < kSteps; ++j) {
      const double phi = (j + 0.5) * 2.0 * M_PI / kSteps;
      const double x = -alpha * r * std::cos(phi), y = -alpha * r * std::sin(phi);
      const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
      const Direction m{x * z, y * z, z};
      const double c = dot(w, m);
      if (!(c > 0.0)) continue;
      // Slopes' density is D cos^4 and d(slopes) = d(omega) / cos^3: D d(omega) = P d(slopes) /
      // cos.
      const double shown = ring * 2.0 * M_PI / kSteps / z * c / w.z;
      const double f = perfect ? 1.0 : reference::fresnel(eta, 0.0, c).unpolarised();
      const Direction up{2 * c * m.x - w.x, 2 * c * m.y - w.y, 2 * c * m.z - w.z};
      if (up.z > 0.0) total.reflected += f * shown / (1.0 + lambda_w + lambda(up));
      const double far2 = 1.0 - (1.0 - c * c) / (eta * eta);
      if (perfect || !(far2 > 0.0)) continue;
      const double along = c / eta - std::sqrt(far2);
      const Direction down{m.x * along - w.x / eta, m.y * along - w.y / eta,
                           m.z * along - w.z / eta};
      if (down.z < 0.0) {
        total.refracted += (1.0 - f) * shown / ((1.0 + lambda_w) * (1.0 + lambda(down)));
      }
    }
  }
  return total;
}

}  // namespace karat::facets
