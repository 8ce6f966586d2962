// Unidirectional path tracing (Kajiya 1986) with next-event estimation, multiple importance
// sampling (Veach and Guibas 1995) and Russian roulette, for all wavelengths of a path at once.
//
// The paths of a batch go from vertex to vertex together. What a scene decides per path (materials,
// lights) is called path by path; the geometry in between is done for the whole batch at once.
//
// Where a direction depends on wavelength, the hero lane chooses it. At finite densities every lane
// is then weighted by the balance heuristic over the lanes' densities of the whole path (Wilkie et
// al., "Hero wavelength spectral sampling", EGSR 2014, eq. 4); where the direction is a delta only
// the hero lane can have taken it, and the others end.
#include <algorithm>
#include <bit>
#include <limits>

#include "render/integrator.h"

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
inline float power_heuristic(float pdf, float other) {
  const float ratio = other / pdf;
  return 1.0f / (1.0f + ratio * ratio);
}

// The densities of the path so far as seen by every lane as hero, over the true hero's. All ones,
// and never touched, until something dispersive is met.
struct LaneDensities {
  SampledSpectrum ratio;  // all ones unless `dispersed`
  bool dispersed;

  // Both return the mean ratio.
  float scatter(const SampledSpectrum& lane_pdfs, float hero_pdf) {
    if (!dispersed) ratio = SampledSpectrum(1.0f);
    dispersed = true;
    ratio *= lane_pdfs;
    ratio *= 1.0f / hero_pdf;
    return mean(ratio);
  }
  float keep_only(int hero) {
    const float own = dispersed ? ratio[hero] : 1.0f;
    dispersed = true;
    ratio = SampledSpectrum(0.0f);
    ratio[hero] = own;
    return own * (1.0f / kLanes);
  }
};

class PathBatch {
 public:
  PathBatch(const Scene& scene, CameraBatch& camera)
      : scene_(scene), camera_(camera), ray_(camera.rays) {
    for (int i = 0; i < kBatch; ++i) {
      camera_.radiance[i] = SampledSpectrum(0.0f);
      throughput_[i] = SampledSpectrum(1.0f);
      densities_[i].dispersed = false;
      mean_ratio_[i] = previous_mean_[i] = eta_squared_[i] = 1.0f;
    }
  }

  void trace(PathCounters& counters) {
    BatchMask active = kWholeBatch;
    for (int depth = 0; active != 0; ++depth) {
      counters.rays += static_cast<std::uint64_t>(std::popcount(active));
      active = arrive(active, depth);
      if (depth >= scene_.settings.max_depth) break;
      active = those(active, [&](int i) { return hit_.surface[i]->material != nullptr; });
      if (active == 0) break;
      counters.vertices += static_cast<std::uint64_t>(std::popcount(active));
      set_vertices(active);
      camera_.sampler.vertex(depth, numbers_);
      const BatchMask lit = choose_lights(active);
      counters.rays += static_cast<std::uint64_t>(std::popcount(lit));
      receive_light(lit);
      active = scatter(active, depth);
    }
  }

 private:
  // Traces the rays, and adds the emission where they end. Returns the paths that met a surface.
  BatchMask arrive(BatchMask active, int depth) {
    const Coherence coherence = depth == 0 ? Coherence::kCamera : Coherence::kNone;
    const BatchMask met = scene_.world.intersect(ray_, active, coherence, hit_);
    for_each(active & ~met, [&](int i) {
      for (const Light* light : scene_.environments) add_emission(i, *light, nullptr);
    });
    for_each(met, [&](int i) {
      if (!hit_.surface[i]->light) return;
      const SurfaceHit hit = hit_[i];
      add_emission(i, *hit.surface->light, &hit);
    });
    if (depth == 0 && !camera_.first_hits.empty()) for_each(met, [&](int i) { note_first_hit(i); });
    return met;
  }

  void note_first_hit(int i) {
    FirstHit& first = camera_.first_hits[static_cast<std::size_t>(i)];
    first.valid = true;
    first.normal = hit_.shading_normal[i];
    first.depth = hit_.distance[i];
    first.shape = hit_.surface[i]->id;
  }

  // Light that the path's last direction has met.
  void add_emission(int i, const Light& light, const SurfaceHit* hit) {
    const Vec3 direction = ray_.direction[i];
    const SampledSpectrum emitted = light.radiance(direction, hit, camera_.wavelengths[i].phase);
    float weight = 1.0f / mean_ratio_[i];
    const float last_pdf = last_pdf_[i];
    if (last_pdf > 0.0f) {
      const Vec3 from = position_[i];
      const float light_pdf = scene_.light_selection.probability(from, &light, chosen_.total[i]) *
                              light.pdf(from, direction, hit);
      weight = last_dispersive_[i]
                   ? 1.0f / (mean_ratio_[i] + previous_mean_[i] * light_pdf / last_pdf)
                   : weight * power_heuristic(last_pdf, light_pdf);
    }
    camera_.radiance[i] += throughput_[i] * emitted * weight;
  }

  // Opaque surfaces look the same from both sides: their frame is turned to the viewer. For the
  // others the inside is where wo.z < 0.
  void set_vertices(BatchMask active) {
    for_each(active, [&](int i) { opaque_[i] = hit_.surface[i]->transmits ? 0 : 1; });
    for_whole_batch([&](int i) {
      const Vec3 away = -ray_.direction[i];
      const float side =
          opaque_[i] != 0 && dot(away, hit_.geometric_normal[i]) < 0.0f ? -1.0f : 1.0f;
      const Vec3 n = hit_.shading_normal[i] * side;
      const Vec3 s = unit_tangent(n, hit_.tangent[i]);
      const Vec3 t = cross(n, s);
      position_.set(i, hit_.position[i]);
      geometric_normal_.set(i, hit_.geometric_normal[i] * side);
      s_.set(i, s);
      t_.set(i, t);
      n_.set(i, n);
      wo_.set(i, {dot(away, s), dot(away, t), dot(away, n)});
    });
    for_each(active, [&](int i) {
      bsdf_[i] = hit_.surface[i]->material->prepare({hit_.position[i], {hit_.u[i], hit_.v[i]}},
                                                    camera_.wavelengths[i], Transport::kRadiance,
                                                    storage_[i]);
    });
  }

  // Next-event estimation up to the question whether the lights are visible. Returns the paths that
  // ask it, with the ray in shadow_ and what the path receives in contribution_.
  BatchMask choose_lights(BatchMask active) {
    scene_.light_selection.choose(position_, numbers_.light_choice, chosen_);
    const BatchMask sampled = those(active, [&](int i) { return sample_light(i); });
    if (sampled == 0) return 0;
    for_whole_batch([&](int i) {
      const Vec3 wi = to_light_[i], position = position_[i];
      wi_.set(i, to_local(i, wi));
      // The segment is aimed anew from the offset origin: kept parallel, and as long as from the
      // vertex itself, it would reach into a light near by.
      const Vec3 origin = offset_origin(position, geometric_normal_[i], wi);
      const bool far = std::isinf(light_distance_[i]);
      const Vec3 segment = wi * light_distance_[i] + (position - origin);
      shadow_.origin.set(i, origin);
      shadow_.direction.set(
          i, {far ? wi.x : segment.x, far ? wi.y : segment.y, far ? wi.z : segment.z});
      shadow_distance_[i] = far ? light_distance_[i] : 1.0f;
    });
    return those(sampled, [&](int i) { return consistent(i, to_light_[i]) && contributes(i); });
  }

  bool sample_light(int i) {
    const Light* light = chosen_.light[i];
    if (!light || hit_.surface[i]->only_delta) return false;
    const auto sample = light->sample(position_[i], {numbers_.light[0][i], numbers_.light[1][i]},
                                      camera_.wavelengths[i].phase);
    if (!sample) return false;
    to_light_.set(i, sample->wi);
    light_distance_[i] = sample->distance;
    light_pdf_[i] = chosen_.probability[i] * sample->pdf;
    contribution_[i] = throughput_[i] * sample->radiance;
    return true;
  }

  bool contributes(int i) {
    const Vec3 wo = wo_[i], wi = wi_[i];
    const BsdfValue bsdf = bsdf_[i]->evaluate(wo, wi);
    if (!(bsdf.pdf > 0.0f)) return false;
    const float light_pdf = light_pdf_[i];
    float weight = 1.0f / (light_pdf * mean_ratio_[i]);
    if (!chosen_.light[i]->is_delta()) {
      if (bsdf_[i]->dispersive()) {
        const SampledSpectrum lane_pdfs = bsdf_[i]->lane_pdfs(wo, wi);
        const LaneDensities& d = densities_[i];
        const float sum_of_others = mean(d.dispersed ? d.ratio * lane_pdfs : lane_pdfs);
        weight = 1.0f / (light_pdf * mean_ratio_[i] + sum_of_others);
      } else {
        weight *= power_heuristic(light_pdf, bsdf.pdf);
      }
    }
    contribution_[i] *= bsdf.value;
    contribution_[i] *= weight;
    return true;
  }

  void receive_light(BatchMask lit) {
    if (lit == 0) return;
    const BatchMask hidden = scene_.world.occluded(shadow_, shadow_distance_, lit);
    for_each(lit & ~hidden, [&](int i) { camera_.radiance[i] += contribution_[i]; });
  }

  // The next directions. Returns the paths that go on.
  BatchMask scatter(BatchMask active, int depth) {
    const BatchMask sampled = those(active, [&](int i) { return sample_bsdf(i); });
    if (sampled == 0) return 0;
    for_whole_batch([&](int i) {
      const Vec3 wi = wi_[i];
      const Vec3 direction = s_[i] * wi.x + t_[i] * wi.y + n_[i] * wi.z;
      ray_.direction.set(i, direction);
      ray_.origin.set(i, offset_origin(position_[i], geometric_normal_[i], direction));
    });
    const BatchMask left = those(sampled, [&](int i) { return consistent(i, ray_.direction[i]); });
    if (depth == 0 && !camera_.first_hits.empty()) {
      for_each(left, [&](int i) {
        camera_.first_hits[static_cast<std::size_t>(i)].albedo =
            throughput_[i] * (1.0f / mean_ratio_[i]);
      });
    }
    if (depth + 1 < kRouletteDepth) return left;
    return those(left, [&](int i) { return survives(i); });
  }

  bool sample_bsdf(int i) {
    const Vec3 wo = wo_[i];
    const auto sample =
        bsdf_[i]->sample(wo, {numbers_.lobe[i], {numbers_.bsdf[0][i], numbers_.bsdf[1][i]}});
    if (!sample) return false;
    wi_.set(i, sample->wi);
    const bool delta = (sample->lobes & lobe::kDelta) != 0;
    previous_mean_[i] = mean_ratio_[i];
    if (sample->dispersive) {
      mean_ratio_[i] =
          delta ? densities_[i].keep_only(camera_.wavelengths[i].hero)
                : densities_[i].scatter(bsdf_[i]->lane_pdfs(wo, sample->wi), sample->pdf);
    }
    throughput_[i] *= sample->weight;
    eta_squared_[i] *= sample->relative_eta * sample->relative_eta;
    last_pdf_[i] = delta ? 0.0f : sample->pdf;
    last_dispersive_[i] = sample->dispersive;
    return true;
  }

  // Paths end in proportion to what they carry; the scaling of radiance by refraction is undone
  // first, since it comes back when the path leaves the medium again.
  bool survives(int i) {
    const float carried = max_lane(throughput_[i]) * eta_squared_[i] / mean_ratio_[i];
    const float probability = std::min(carried / kRouletteThreshold, 1.0f);
    if (!(numbers_.roulette[i] < probability)) return false;
    throughput_[i] *= 1.0f / probability;
    return true;
  }

  Vec3 to_local(int i, const Vec3& v) const {
    return {dot(v, s_[i]), dot(v, t_[i]), dot(v, n_[i])};
  }

  // Whether a world direction leaves on the side that its local form, wi_, is on: an interpolated
  // normal may put a reflected direction below the actual surface.
  bool consistent(int i, const Vec3& world) const {
    return dot(world, geometric_normal_[i]) * wi_.z[i] > 0.0f;
  }

  const Scene& scene_;
  CameraBatch& camera_;
  BatchRay ray_;
  BatchHit hit_;

  SampledSpectrum throughput_[kBatch];
  LaneDensities densities_[kBatch];
  BatchFloat mean_ratio_, previous_mean_;  // of the densities, now and before the last vertex
  BatchFloat eta_squared_;
  BatchFloat last_pdf_;  // 0: the camera or a delta lobe, which no light sample competes with
  bool last_dispersive_[kBatch] = {};

  // Of the present vertex.
  BatchVec3 position_, geometric_normal_, s_, t_, n_, wo_, wi_;
  std::int32_t opaque_[kBatch] = {};
  const Bsdf* bsdf_[kBatch];
  BatchVertexNumbers numbers_;
  LightSelection::Choice chosen_;
  BatchVec3 to_light_;
  BatchFloat light_distance_, light_pdf_, shadow_distance_;
  BatchRay shadow_;
  SampledSpectrum contribution_[kBatch];
  BsdfStorage storage_[kBatch];
};

class PathIntegrator final : public Integrator {
 public:
  std::string description() const override {
    return "path tracer with next-event estimation and multiple importance sampling";
  }
  void trace(const Scene& scene, CameraBatch& batch, PathCounters& counters) const override {
    PathBatch(scene, batch).trace(counters);
  }
};

KARAT_REGISTER(Integrator, "path", PathIntegrator);

}  // namespace
}  // namespace karat
