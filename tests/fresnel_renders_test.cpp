// Renders with one Fresnel model after the other.
#include "render/fresnel_renders.h"

#include <catch2/catch.hpp>

#include "render/fresnel_probes.h"
#include "spectral/colour.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

Image plain(float r, float g, float b) {
  Image image;
  image.width = image.height = 1;
  image.channels = {"R", "G", "B"};
  image.values = {r, g, b};
  return image;
}

FresnelRenderOptions small(std::vector<std::string> models) {
  FresnelRenderOptions options;
  options.scene = data_path("scenes/fresnel_rings.json");
  options.models = std::move(models);
  options.width = 48, options.height = 27;
  options.spp = 4, options.rounds = 2;
  return options;
}

}  // namespace

TEST_CASE("picture differences are CIEDE2000 of what a display shows", "[fresnel_renders]") {
  const Xyz white = xyz_of_linear_srgb({1, 1, 1});
  const double expected = delta_e_2000(lab_of_xyz(xyz_of_linear_srgb({0.5, 0.2, 0.1}), white),
                                       lab_of_xyz(xyz_of_linear_srgb({0.4, 0.2, 0.1}), white));
  const auto difference = picture_difference(plain(0.5f, 0.2f, 0.1f), plain(0.4f, 0.2f, 0.1f));
  CHECK(difference.mean == Approx(expected).epsilon(1e-5));
  CHECK(difference.max == difference.mean);
  // Beyond white a display shows no difference.
  CHECK(picture_difference(plain(3, 3, 3), plain(1, 1, 1)).max == 0.0);
}

TEST_CASE("a probe is exact, counts, and leaves no trace", "[fresnel_renders]") {
  const auto& registry = Registry<FresnelModel>::instance();
  std::string name;
  {
    const FresnelProbe probe(3, true);
    name = probe.name();
    const FresnelModel& watched = *registry.find(name);
    const FresnelModel& exact = *registry.find("exact");
    const LatticeIndex index = on_lattice(*constant_index({0.2, 3.0}), WavelengthLattice());
    const FresnelTables tables = watched.prepare(index);
    CHECK(watched.reflectance(tables, 5, 0.3f)[2] == exact.reflectance(tables, 5, 0.3f)[2]);
    CHECK(probe.calls() == 1);
  }
  CHECK(registry.find(name) == nullptr);
}

TEST_CASE("exact differs from itself by nothing, and approximations by something",
          "[fresnel_renders]") {
  double last = 0.0;
  FresnelRenderOptions options = small({"schlick", "exact"});
  options.progress = [&](double done) {
    CHECK(done > last);
    last = done;
  };
  const FresnelRenders renders = render_fresnel_models(options);
  CHECK(last == Approx(1.0));
  REQUIRE(renders.models.size() == 2);
  CHECK(renders.models[0].model == "exact");
  CHECK(renders.models[0].difference.max == 0.0);
  CHECK(renders.models[0].relative_time.median == 1.0);
  CHECK(renders.models[1].difference.max > 0.0);
  CHECK(renders.models[1].difference.delta_e.size() == 48u * 27u);
  CHECK(renders.noise.mean > renders.models[1].difference.mean);
  // The same work but for its random numbers. (Milliseconds, on a machine that does other things.)
  CHECK(renders.noise_time.median > 0.2);
  CHECK(renders.noise_time.median < 5.0);
  // Rings fill a part of the picture, and light is reflected more than once between some of them.
  CHECK(renders.evaluations_per_sample > 0.1);
  CHECK(renders.evaluations_per_sample < 12.0);
  CHECK_THROWS_AS(render_fresnel_models(small({"schlik"})), InputError);
}
