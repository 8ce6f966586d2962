// Unidirectional path tracing (Kajiya 1986) with next-event estimation, multiple importance
// sampling (Veach and Guibas 1995) and Russian roulette, for all wavelengths of a path at once.
//
// Where a direction depends on wavelength, the hero lane chooses it. At finite densities every lane
// is then weighted by the balance heuristic over the lanes' densities of the whole path (Wilkie et
// al., "Hero wavelength spectral sampling", EGSR 2014, eq. 4); where the direction is a delta only
// the hero lane can have taken it, and the others end.
#include <algorithm>

#include "render/integrator.h"
#include "render/integrators/vertex.h"

namespace karat {
namespace {

// Roulette is played from this scattering event on, and only with paths that carry less than
// kRouletteThreshold. Ending brighter ones saves few rays and costs much: on three mirror-like
// rings at 16 samples per pixel a threshold of 1 traces 4 % fewer rays at 1.5 times the relative
// squared error.
constexpr int kRouletteDepth = 3;
constexpr float kRouletteThreshold = 0.25f;

// Veach 1997, section 9.2.4, with exponent 2; pdf > 0. Through the ratio, so that squares of
// extreme densities do no harm.
float power_heuristic(float pdf, float other) {
  const float ratio = other / pdf;
  return 1.0f / (1.0f + ratio * ratio);
}

// The densities of the path so far as seen by every lane as hero, over the true hero's. All ones,
// and never touched, until something dispersive is met.
struct LaneDensities {
  SampledSpectrum ratio{1.0f};
  float mean_ratio = 1.0f;
  float previous_mean = 1.0f;  // before the last vertex
  bool dispersed = false;

  void scatter(const SampledSpectrum& lane_pdfs, float hero_pdf) {
    dispersed = true;
    ratio *= lane_pdfs;
    ratio *= 1.0f / hero_pdf;
    mean_ratio = mean(ratio);
  }
  void keep_only(int hero) {
    dispersed = true;
    const float own = ratio[hero];
    ratio = SampledSpectrum(0.0f);
    ratio[hero] = own;
    mean_ratio = own * (1.0f / kLanes);
  }
};

// One path and what it has gathered.
class Path {
 public:
  Path(const Scene& scene, SampledWavelengths wavelengths, Sampler& sampler, PathCounters& counters)
      : scene_(scene), wavelengths_(wavelengths), sampler_(sampler), counters_(counters) {}

  SampledSpectrum trace(Ray ray, FirstHit* first_hit) {
    const int max_depth = scene_.settings.max_depth;
    for (int depth = 0;; ++depth) {
      SurfaceHit hit;
      ++counters_.rays;
      if (!scene_.world.intersect(ray, hit)) {
        for (const Light* light : scene_.environments) add_emission(*light, ray, nullptr);
        break;
      }
      if (hit.surface->light) add_emission(*hit.surface->light, ray, &hit);
      if (depth == 0 && first_hit) {
        first_hit->valid = true;
        first_hit->normal = hit.shading_normal;
        first_hit->depth = hit.distance;
        first_hit->shape = hit.surface->id;
      }
      if (depth >= max_depth || !hit.surface->material) break;

      BsdfStorage storage;
      const Vertex vertex(hit, ray.direction, wavelengths_, storage);
      ++counters_.vertices;
      const VertexNumbers u = sampler_.vertex(depth);
      if (!vertex.only_delta) add_direct_light(vertex, u);
      if (!scatter(vertex, u, ray)) break;
      if (depth == 0 && first_hit) first_hit->albedo = throughput_;
      if (depth + 1 >= kRouletteDepth && !survives(u.roulette)) break;
    }
    return radiance_;
  }

 private:
  // Light that the path's last direction has met.
  void add_emission(const Light& light, const Ray& ray, const SurfaceHit* hit) {
    const SampledSpectrum emitted = light.radiance(ray.direction, hit, wavelengths_.phase);
    float weight = 1.0f / densities_.mean_ratio;
    if (last_pdf_ > 0.0f) {
      const float light_pdf = scene_.light_selection.probability(last_position_, &light) *
                              light.pdf(last_position_, ray.direction, hit);
      weight =
          last_dispersive_
              ? 1.0f / (densities_.mean_ratio + densities_.previous_mean * light_pdf / last_pdf_)
              : weight * power_heuristic(last_pdf_, light_pdf);
    }
    radiance_ += throughput_ * emitted * weight;
  }

  void add_direct_light(const Vertex& vertex, const VertexNumbers& u) {
    const auto [light, probability] =
        scene_.light_selection.choose(vertex.position, u.light_choice);
    if (!light) return;
    const auto sample = light->sample(vertex.position, u.light, wavelengths_.phase);
    if (!sample) return;
    const Vec3 wi = vertex.frame.to_local(sample->wi);
    if (!vertex.consistent(sample->wi, wi)) return;
    const BsdfValue bsdf = vertex.bsdf->evaluate(vertex.wo, wi);
    if (!(bsdf.pdf > 0.0f)) return;

    ++counters_.rays;
    if (!vertex.sees(scene_.world, sample->wi, sample->distance)) return;

    const float light_pdf = probability * sample->pdf;
    float weight = 1.0f / (light_pdf * densities_.mean_ratio);
    if (!light->is_delta()) {
      if (vertex.bsdf->dispersive()) {
        const SampledSpectrum lane_pdfs = vertex.bsdf->lane_pdfs(vertex.wo, wi);
        weight = 1.0f / (light_pdf * densities_.mean_ratio + mean(densities_.ratio * lane_pdfs));
      } else {
        weight *= power_heuristic(light_pdf, bsdf.pdf);
      }
    }
    radiance_ += throughput_ * bsdf.value * sample->radiance * weight;
  }

  bool scatter(const Vertex& vertex, const VertexNumbers& u, Ray& ray) {
    const auto sample = vertex.bsdf->sample(vertex.wo, {u.lobe, u.bsdf});
    if (!sample) return false;
    const Vec3 direction = vertex.frame.to_world(sample->wi);
    if (!vertex.consistent(direction, sample->wi)) return false;

    const bool delta = (sample->lobes & lobe::kDelta) != 0;
    densities_.previous_mean = densities_.mean_ratio;
    if (sample->dispersive) {
      if (delta) {
        densities_.keep_only(wavelengths_.hero);
      } else {
        densities_.scatter(vertex.bsdf->lane_pdfs(vertex.wo, sample->wi), sample->pdf);
      }
    }
    throughput_ *= sample->weight;
    eta_squared_ *= sample->relative_eta * sample->relative_eta;
    last_pdf_ = delta ? 0.0f : sample->pdf;
    last_dispersive_ = sample->dispersive;
    last_position_ = vertex.position;
    ray = vertex.spawn(direction);
    return true;
  }

  // Paths end in proportion to what they carry; the scaling of radiance by refraction is undone
  // first, since it comes back when the path leaves the medium again.
  bool survives(float u) {
    const float carried = max_lane(throughput_) * eta_squared_ / densities_.mean_ratio;
    const float probability = std::min(carried / kRouletteThreshold, 1.0f);
    if (!(u < probability)) return false;
    throughput_ *= 1.0f / probability;
    return true;
  }

  const Scene& scene_;
  const SampledWavelengths wavelengths_;
  Sampler& sampler_;
  PathCounters& counters_;

  SampledSpectrum radiance_{0.0f}, throughput_{1.0f};
  LaneDensities densities_;
  float eta_squared_ = 1.0f;
  Vec3 last_position_;
  float last_pdf_ = 0.0f;  // 0: the camera or a delta lobe, which no light sample competes with
  bool last_dispersive_ = false;
};

class PathIntegrator final : public Integrator {
 public:
  std::string description() const override {
    return "path tracer with next-event estimation and multiple importance sampling";
  }
  SampledSpectrum radiance(const Scene& scene, const Ray& ray, SampledWavelengths wavelengths,
                           Sampler& sampler, PathCounters& counters,
                           FirstHit* first_hit) const override {
    return Path(scene, wavelengths, sampler, counters).trace(ray, first_hit);
  }
};

KARAT_REGISTER(Integrator, "path", PathIntegrator);

}  // namespace
}  // namespace karat
