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

// One path, taken from vertex to vertex in steps: arrive, choose_light, receive_light, scatter.
class Path {
 public:
  Path(const Scene& scene, CameraSample& sample)
      : scene_(scene), sample_(sample), ray_(sample.ray), wavelengths_(sample.wavelengths) {
    sample_.radiance = SampledSpectrum(0.0f);
  }

  void trace_ray() { found_ = scene_.world.intersect(ray_, hit_); }

  // Emission where the ray ends, and the vertex there; false where the path ends with it.
  bool arrive(int depth, PathCounters& counters) {
    ++counters.rays;
    if (!found_) {
      for (const Light* light : scene_.environments) add_emission(*light, nullptr);
      return false;
    }
    if (hit_.surface->light) add_emission(*hit_.surface->light, &hit_);
    if (depth == 0 && sample_.first_hit.wanted) note_first_hit();
    if (depth >= scene_.settings.max_depth || !hit_.surface->material) return false;
    ++counters.vertices;
    numbers_ = sample_.sampler.vertex(depth);
    vertex_.set(hit_, ray_.direction, wavelengths_, storage_);
    return true;
  }

  // Next-event estimation up to the question whether the light is visible; false without one.
  bool choose_light() {
    if (vertex_.only_delta) return false;
    const auto [light, probability] =
        scene_.light_selection.choose(vertex_.position, numbers_.light_choice);
    if (!light) return false;
    const auto sample = light->sample(vertex_.position, numbers_.light, wavelengths_.phase);
    if (!sample) return false;
    const Vec3 wi = vertex_.frame.to_local(sample->wi);
    if (!vertex_.consistent(sample->wi, wi)) return false;
    const BsdfValue bsdf = vertex_.bsdf->evaluate(vertex_.wo, wi);
    if (!(bsdf.pdf > 0.0f)) return false;

    const float light_pdf = probability * sample->pdf;
    float weight = 1.0f / (light_pdf * densities_.mean_ratio);
    if (!light->is_delta()) {
      if (vertex_.bsdf->dispersive()) {
        const SampledSpectrum lane_pdfs = vertex_.bsdf->lane_pdfs(vertex_.wo, wi);
        weight = 1.0f / (light_pdf * densities_.mean_ratio + mean(densities_.ratio * lane_pdfs));
      } else {
        weight *= power_heuristic(light_pdf, bsdf.pdf);
      }
    }
    light_direction_ = sample->wi;
    light_distance_ = sample->distance;
    light_contribution_ = throughput_ * bsdf.value * sample->radiance * weight;
    return true;
  }

  void receive_light(PathCounters& counters) {
    ++counters.rays;
    if (vertex_.sees(scene_.world, light_direction_, light_distance_)) {
      sample_.radiance += light_contribution_;
    }
  }

  // The next direction; false where the path ends.
  bool scatter(int depth) {
    const auto sample = vertex_.bsdf->sample(vertex_.wo, {numbers_.lobe, numbers_.bsdf});
    if (!sample) return false;
    const Vec3 direction = vertex_.frame.to_world(sample->wi);
    if (!vertex_.consistent(direction, sample->wi)) return false;

    const bool delta = (sample->lobes & lobe::kDelta) != 0;
    densities_.previous_mean = densities_.mean_ratio;
    if (sample->dispersive) {
      if (delta) {
        densities_.keep_only(wavelengths_.hero);
      } else {
        densities_.scatter(vertex_.bsdf->lane_pdfs(vertex_.wo, sample->wi), sample->pdf);
      }
    }
    throughput_ *= sample->weight;
    eta_squared_ *= sample->relative_eta * sample->relative_eta;
    last_pdf_ = delta ? 0.0f : sample->pdf;
    last_dispersive_ = sample->dispersive;
    last_position_ = vertex_.position;
    ray_ = vertex_.spawn(direction);
    if (depth == 0 && sample_.first_hit.wanted) {
      sample_.first_hit.albedo = throughput_ * (1.0f / densities_.mean_ratio);
    }
    return depth + 1 < kRouletteDepth || survives(numbers_.roulette);
  }

 private:
  void note_first_hit() {
    FirstHit& first = sample_.first_hit;
    first.valid = true;
    first.normal = hit_.shading_normal;
    first.depth = hit_.distance;
    first.shape = hit_.surface->id;
  }

  // Light that the path's last direction has met.
  void add_emission(const Light& light, const SurfaceHit* hit) {
    const SampledSpectrum emitted = light.radiance(ray_.direction, hit, wavelengths_.phase);
    float weight = 1.0f / densities_.mean_ratio;
    if (last_pdf_ > 0.0f) {
      const float light_pdf = scene_.light_selection.probability(last_position_, &light) *
                              light.pdf(last_position_, ray_.direction, hit);
      weight =
          last_dispersive_
              ? 1.0f / (densities_.mean_ratio + densities_.previous_mean * light_pdf / last_pdf_)
              : weight * power_heuristic(last_pdf_, light_pdf);
    }
    sample_.radiance += throughput_ * emitted * weight;
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
  CameraSample& sample_;
  Ray ray_;
  const SampledWavelengths wavelengths_;

  SampledSpectrum throughput_{1.0f};
  LaneDensities densities_;
  float eta_squared_ = 1.0f;
  float last_pdf_ = 0.0f;  // 0: the camera or a delta lobe, which no light sample competes with
  Vec3 last_position_;
  bool last_dispersive_ = false;

  // Of the present vertex.
  bool found_ = false;
  SurfaceHit hit_;
  Vertex vertex_;
  VertexNumbers numbers_;
  Vec3 light_direction_;
  float light_distance_;
  SampledSpectrum light_contribution_;
  BsdfStorage storage_;
};

// The paths of a batch go through each step together, which lets steps of different paths overlap.
// By itself this gains nothing that could be measured on three_tori; it is the form that steps in
// lanes across paths would need.
class Batch {
 public:
  Batch(const Scene& scene, std::span<CameraSample> samples) {
    for (CameraSample& sample : samples) {
      void* place = bytes_ + sizeof(Path) * static_cast<std::size_t>(count_);
      active_[count_] = new (place) Path(scene, sample);
      ++count_;
    }
  }

  void trace(PathCounters& counters) {
    for (int depth = 0; count_ > 0; ++depth) {
      for (int i = 0; i < count_; ++i) active_[i]->trace_ray();
      keep([&](Path& path) { return path.arrive(depth, counters); });
      const int lit = select_lit();
      for (int i = 0; i < lit; ++i) lit_[i]->receive_light(counters);
      keep([&](Path& path) { return path.scatter(depth); });
    }
  }

 private:
  template <typename Step>
  void keep(Step&& step) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      Path* path = active_[i];
      if (step(*path)) active_[kept++] = path;
    }
    count_ = kept;
  }

  int select_lit() {
    int lit = 0;
    for (int i = 0; i < count_; ++i) {
      if (active_[i]->choose_light()) lit_[lit++] = active_[i];
    }
    return lit;
  }

  alignas(64) std::byte bytes_[sizeof(Path) * kBatch];
  Path* active_[kBatch];
  Path* lit_[kBatch];
  int count_ = 0;
};

class PathIntegrator final : public Integrator {
 public:
  std::string description() const override {
    return "path tracer with next-event estimation and multiple importance sampling";
  }
  void trace(const Scene& scene, std::span<CameraSample> samples,
             PathCounters& counters) const override {
    Batch(scene, samples).trace(counters);
  }
};

KARAT_REGISTER(Integrator, "path", PathIntegrator);

}  // namespace
}  // namespace karat
