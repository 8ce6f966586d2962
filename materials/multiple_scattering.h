// The light that meets a rough dielectric interface more than once.
#pragma once

#include <vector>

#include "materials/bsdf.h"
#include "materials/missing_energy.h"
#include "spectral/spectrum.h"

namespace karat {

// Kulla and Conty, "Revisiting physically based shading at Imageworks", SIGGRAPH 2017 course on
// physically based shading, reflection and transmission: what single scattering lacks to 1 leaves
// in a lobe of its own. For wo on side X and wi on side Y of the interface, each lane with its eta,
//
//   f*(wo, wi) = share(X to Y) (1 - E_X(wo)) (1 - E_Y(wi)) / (pi (1 - mean E_Y))
//
// f* is what importance is scattered by (radiance: f* / eta^2 where refracted); with share(X to X)
// + share(X to Y) = 1 it adds exactly what is missing. n_X^2 f*(wo, wi) = n_Y^2 f*(wi, wo) (Veach
// 1997, equation 5.14) asks that n_A^2 (1 - mean E_A) share(A to B) be the same with A and B
// exchanged, which leaves one number: how much crosses. Here trapped light meets the surface again
// as diffuse light does, until it leaves (energy_shares in the source file).
class MultipleScattering {
 public:
  // eta: index below over index above.
  MultipleScattering(const Roughness& roughness, const LatticeSpectrum& eta, bool dispersive);

  // Values include the cosine of wi and carry importance; densities are those of every lane.
  struct Densities {
    SampledSpectrum value, pdf;
  };
  // `eta_o` and `eta_i` are the indices of the far side over those of the side of wo and of wi.
  Densities densities(const Vec3& wo, const Vec3& wi, const SampledSpectrum& eta_o,
                      const SampledSpectrum& eta_i, int phase) const;

  // A direction of the lobe of `hero`. The numbers have made other choices before: these are mixed
  // into new ones.
  Vec3 sample(const Vec3& wo, const BsdfNumbers& used, int phase, int hero) const;

 private:
  // Densities of sampling over cos(theta), common to all wavelengths: steps over the squared
  // cosine, uniform in azimuth, in proportion to what is missing on average.
  struct Side {
    static constexpr int kSteps = 64;
    MissingEnergy missing;
    LatticeSpectrum crossing;            // share(X to Y)
    LatticeSpectrum inverse_missing;     // 1 / (pi (1 - mean E_X))
    std::vector<float> squares = {};     // of the cosine: kSteps + 1 bounds
    std::vector<float> cumulative = {};  // the same, of probability
    std::vector<float> density = {};     // over the cosine: per solid angle

    void prepare_sampling(double eta_least, double eta_largest);
    float pdf(float cos_theta) const;
  };
  MultipleScattering(const FacetQuadrature& quadrature, Vec2 alpha, const LatticeSpectrum& eta,
                     bool dispersive);
  void copy_first(int phase, int lane);
  void share_out(int phase, int lane, double eta);
  const Side& side(float z) const { return z > 0.0f ? above_ : below_; }

  bool dispersive_;
  Side above_, below_;
};

}  // namespace karat
