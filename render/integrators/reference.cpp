// The literal estimator of the rendering equation, kept as the check of the path tracer: one
// wavelength a path, directions uniform over the sphere, light found by chance alone. No next-event
// estimation, no importance sampling, no Russian roulette, no sharing of wavelengths. Only what
// chance cannot meet is treated apart: delta lobes are sampled, and delta lights are added up at
// every vertex.
#include "materials/sampling.h"
#include "render/integrator.h"
#include "render/integrators/vertex.h"

namespace karat {
namespace {

class ReferenceIntegrator final : public Integrator {
 public:
  std::string description() const override {
    return "literal reference: uniform directions, one wavelength a path";
  }

  void trace(const Scene& scene, CameraBatch& batch, PathCounters& counters) const override {
    for (int i = 0; i < kBatch; ++i) {
      batch.radiance[i] = SampledSpectrum(0.0f);
      batch.radiance[i][batch.wavelengths[i].hero] =
          kLanes * hero_radiance(scene, batch, i, counters);
    }
  }

 private:
  static float hero_radiance(const Scene& scene, const CameraBatch& batch, int i,
                             PathCounters& counters) {
    const SampledWavelengths wavelengths = batch.wavelengths[i];
    const int hero = wavelengths.hero, phase = wavelengths.phase;
    Sampler sampler = batch.sampler.path(i);
    Ray ray{batch.rays.origin[i], batch.rays.direction[i]};
    float result = 0.0f, throughput = 1.0f;
    for (int depth = 0;; ++depth) {
      SurfaceHit hit;
      ++counters.rays;
      if (!scene.world.intersect(ray, hit)) {
        for (const Light* light : scene.environments) {
          result += throughput * light->radiance(ray.direction, nullptr, phase)[hero];
        }
        break;
      }
      if (hit.surface->light) {
        result += throughput * hit.surface->light->radiance(ray.direction, &hit, phase)[hero];
      }
      if (depth >= scene.settings.max_depth || !hit.surface->material) break;

      BsdfStorage storage;
      Vertex vertex;
      vertex.set(hit, ray.direction, wavelengths, storage);
      ++counters.vertices;
      const VertexNumbers u = sampler.vertex(depth);
      result += throughput * from_delta_lights(scene, vertex, phase, hero, counters);

      Vec3 wi;
      if (vertex.only_delta) {
        const auto sample = vertex.bsdf->sample(vertex.wo, {u.lobe, u.bsdf});
        if (!sample) break;
        wi = sample->wi;
        throughput *= sample->weight[hero];
      } else {
        wi = square_to_sphere(u.bsdf);
        throughput *= vertex.bsdf->evaluate(vertex.wo, wi).value[hero] * 4.0f * kPi;
      }
      const Vec3 direction = vertex.frame.to_world(wi);
      if (!(throughput > 0.0f) || !vertex.consistent(direction, wi)) break;
      ray = vertex.spawn(direction);
    }
    return result;
  }

  static float from_delta_lights(const Scene& scene, const Vertex& vertex, int phase, int hero,
                                 PathCounters& counters) {
    float sum = 0.0f;
    for (const auto& light : scene.lights) {
      if (!light->is_delta()) continue;
      const auto sample = light->sample(vertex.position, {0.5f, 0.5f}, phase);
      if (!sample) continue;
      const Vec3 wi = vertex.frame.to_local(sample->wi);
      if (!vertex.consistent(sample->wi, wi)) continue;
      const float value = vertex.bsdf->evaluate(vertex.wo, wi).value[hero];
      ++counters.rays;
      if (value > 0.0f && vertex.sees(scene.world, sample->wi, sample->distance)) {
        sum += value * sample->radiance[hero];
      }
    }
    return sum;
  }
};

KARAT_REGISTER(Integrator, "reference", ReferenceIntegrator);

}  // namespace
}  // namespace karat
