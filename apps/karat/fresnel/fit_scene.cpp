#include "apps/karat/fresnel/fit_scene.h"

#include <fstream>

#include "render/replace_file.h"
#include "render/scene_json.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using OrderedJson = nlohmann::ordered_json;

// What a scene says to use these values.
OrderedJson scene_choice(const std::string& model, const FresnelFits& fits) {
  OrderedJson parameters;
  for (std::size_t p = 0; p < fits.parameters.size(); ++p) {
    OrderedJson& value = parameters[fits.parameters[p].name];
    if (!fits.per_wavelength || fits.fits.size() == 1) {
      value = fits.fits[0].values[p];
      continue;
    }
    OrderedJson rows = OrderedJson::array();
    for (std::size_t i = 0; i < fits.fits.size(); ++i) {
      rows.push_back({fits.wavelengths_nm[i], fits.fits[i].values[p]});
    }
    value["table"] = rows;
  }
  return {{"model", model}, {"parameters", parameters}};
}

// The conductors of a scene that are made of the page, or the one that is asked for.
std::vector<std::string> materials_of(const FitScene& place, const JsonValue& scene) {
  std::vector<std::string> conductors, found;
  const JsonValue materials = scene.member("materials");
  for (const std::string& name : materials.require_object().keys()) {
    const JsonValue material = materials.member(name);
    if (!material.has("type") || material.member("type").json() != "conductor") continue;
    conductors.push_back(name);
    const bool same_page = material.has("nk") && material.member("nk").json() == place.page;
    if (place.material.empty() ? same_page : name == place.material) found.push_back(name);
  }
  if (!found.empty()) return found;
  if (!place.material.empty()) {
    materials.fail(unknown_name_message("conductor", place.material, conductors));
  }
  materials.fail("no conductor has \"nk\": \"" + place.page + "\"; name one with --material");
}

}  // namespace

std::vector<std::string> write_fit_to_scene(const FitScene& place, const std::string& model,
                                            const FresnelFits& fits) {
  const std::string text = read_text_file(place.input, kMaxSceneBytes);
  const Json checked = parse_json(text, place.input);
  const std::vector<std::string> names = materials_of(place, JsonValue(checked, place.input));
  OrderedJson scene = OrderedJson::parse(text);
  for (const std::string& name : names) {
    scene["materials"][name]["fresnel"] = scene_choice(model, fits);
  }
  replace_file(place.output, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << scene.dump(2) << '\n';
    if (!file.flush()) throw RuntimeError("cannot write \"" + place.output + "\"");
  });
  return names;
}

}  // namespace karat
