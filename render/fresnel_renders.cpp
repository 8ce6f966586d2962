#include "render/fresnel_renders.h"

#include <sys/resource.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>

#include "render/film_image.h"
#include "render/fresnel_probes.h"
#include "render/renderer.h"
#include "render/scene_loader.h"
#include "spectral/colour.h"

namespace karat {
namespace {

// Many, since one takes far less of a render's time than other programs do.
constexpr int kProbeEvaluations = 65;

double process_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// A scene with one model, and the film that it fills round by round.
class Contestant {
 public:
  Contestant(const FresnelRenderOptions& options, const std::string& model,
             std::uint32_t seed_offset = 0)
      : options_(options), scene_(load(options, model)), film_(make_film(scene_)) {
    scene_.settings.seed += seed_offset;
  }

  // Renders samples [first, last) of every pixel.
  void render_samples(int first, int last) {
    scene_.settings.spp = last;
    RenderOptions render_options;
    render_options.threads = options_.threads;
    render_options.first_sample = first;
    const double start = process_seconds();
    render(scene_, render_options, film_);
    seconds_.push_back(process_seconds() - start);
  }

  Image picture() const { return film_image(scene_, film_); }
  const Scene& scene() const { return scene_; }
  const std::vector<double>& seconds() const { return seconds_; }
  double total_seconds() const { return std::accumulate(seconds_.begin(), seconds_.end(), 0.0); }

 private:
  static Scene load(const FresnelRenderOptions& options, const std::string& model) {
    SceneOverrides overrides;
    overrides.fresnel = model;
    if (options.width > 0) overrides.width = options.width;
    if (options.height > 0) overrides.height = options.height;
    overrides.spp = options.spp;
    return load_scene(options.scene, overrides);
  }
  static Film make_film(const Scene& scene) {
    const RenderSettings& settings = scene.settings;
    return {settings.crop, {}, Sensor::make(settings.observer, scene.lattice)};
  }

  const FresnelRenderOptions& options_;
  Scene scene_;
  Film film_;
  std::vector<double> seconds_;
};

std::vector<std::string> exact_first(const std::vector<std::string>& models) {
  std::vector<std::string> names{"exact"};
  for (const auto& name : models) {
    if (name != "exact") names.push_back(name);
  }
  return names;
}

// Per round, the time of `a` over that of `b`.
std::vector<double> ratios(const Contestant& a, const Contestant& b) {
  std::vector<double> values;
  for (std::size_t i = 0; i < a.seconds().size(); ++i) {
    values.push_back(a.seconds()[i] / std::max(b.seconds()[i], 1e-9));
  }
  return values;
}

// Of the exact model at every place `evaluations - 1` times more, at the same paths.
CostSpread share_of(std::vector<double> time_ratios) {
  for (double& ratio : time_ratios) ratio = (ratio - 1.0) / (kProbeEvaluations - 1);
  return cost_spread(std::move(time_ratios));
}

// Calls of the model in one sample of every pixel.
double count_evaluations(const FresnelRenderOptions& options) {
  const FresnelProbe probe(1, true);
  Contestant contestant(options, probe.name());
  contestant.render_samples(0, 1);
  const Crop crop = contestant.scene().settings.crop;
  return static_cast<double>(probe.calls()) /
         (static_cast<double>(crop.x1 - crop.x0) * (crop.y1 - crop.y0));
}

}  // namespace

PictureDifference picture_difference(const Image& a, const Image& b) {
  const Xyz white = xyz_of_linear_srgb({1.0, 1.0, 1.0});
  const auto lab = [&](const Image& image, std::size_t pixel) {
    const float* rgb = &image.values[pixel * image.channels.size()];
    Rgb shown;
    for (std::size_t i = 0; i < 3; ++i) shown[i] = std::clamp(double{rgb[i]}, 0.0, 1.0);
    return lab_of_xyz(xyz_of_linear_srgb(shown), white);
  };
  PictureDifference difference;
  const std::size_t pixels = a.values.size() / a.channels.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const double delta_e = delta_e_2000(lab(a, i), lab(b, i));
    difference.delta_e.push_back(static_cast<float>(delta_e));
    difference.max = std::max(difference.max, delta_e);
    sum += delta_e;
  }
  difference.mean = sum / static_cast<double>(pixels);
  std::vector<float> sorted = difference.delta_e;
  const auto place =
      sorted.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(pixels));
  std::nth_element(sorted.begin(), place, sorted.end());
  difference.p95 = double{*place};
  return difference;
}

FresnelRenders render_fresnel_models(const FresnelRenderOptions& options) {
  const FresnelProbe repeated(kProbeEvaluations, false);
  const std::vector<std::string> names = exact_first(options.models);
  std::vector<std::unique_ptr<Contestant>> contestants;
  for (const auto& name : names) contestants.push_back(std::make_unique<Contestant>(options, name));
  contestants.push_back(std::make_unique<Contestant>(options, repeated.name()));
  contestants.push_back(std::make_unique<Contestant>(options, "exact", 1u));

  const int rounds = std::clamp(options.rounds, 1, options.spp);
  std::vector<Contestant*> order;
  for (const auto& contestant : contestants) order.push_back(contestant.get());
  std::mt19937 generator;
  double turns = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const int first = options.spp * round / rounds, last = options.spp * (round + 1) / rounds;
    std::shuffle(order.begin(), order.end(), generator);  // nobody always follows the same one
    for (Contestant* contestant : order) {
      contestant->render_samples(first, last);
      turns += 1.0;
      if (options.progress) options.progress(turns / (rounds * static_cast<double>(order.size())));
    }
  }

  FresnelRenders result;
  const Contestant& exact = *contestants.front();
  const Image reference = exact.picture();
  result.width = reference.width, result.height = reference.height, result.spp = options.spp;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Contestant& contestant = *contestants[i];
    Image picture = contestant.picture();
    PictureDifference difference = picture_difference(picture, reference);
    result.models.push_back({names[i], std::move(picture), std::move(difference),
                             cost_spread(ratios(contestant, exact)), contestant.total_seconds()});
  }
  result.fresnel_share = share_of(ratios(*contestants[names.size()], exact));
  const Contestant& exact_again = *contestants.back();
  result.noise = picture_difference(exact_again.picture(), reference);
  result.noise_time = cost_spread(ratios(exact_again, exact));
  result.evaluations_per_sample = count_evaluations(options);
  return result;
}

}  // namespace karat
