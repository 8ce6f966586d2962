#include "render/scene_loader.h"

#include <filesystem>

#include "materials/fresnel.h"
#include "render/scene_builder.h"
#include "render/scene_overrides.h"
#include "render/scene_schema.h"
#include "render/scene_settings.h"
#include "spectral/colour.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

const std::vector<std::string> kSections{"$schema",     "wavelengths",   "observer",  "white",
                                         "extrapolate", "interpolation", "camera",    "film",
                                         "sampling",    "integrator",    "materials", "shapes",
                                         "groups",      "instances",     "lights"};

void require_fresnel(const std::string& name) {
  const auto& registry = Registry<FresnelModel>::instance();
  if (!name.empty() && !registry.find(name)) {
    throw InputError("", "--fresnel",
                     unknown_name_message("Fresnel model", name, registry.names()));
  }
}

void require_white(const JsonValue& document, const RenderSettings& settings) {
  try {
    white_xyz(settings.white, observer(settings.observer));
  } catch (const InputError& error) {
    if (document.has("white")) document.member("white").fail(error.what());
    throw;
  }
}

// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

// What decides the value of a sample: the document after all changes, and the program's version.
// The number of samples is left out, so that a render can be resumed with more of them.
std::uint64_t content_hash(Json document, const RenderSettings& settings,
                           const SceneOverrides& overrides) {
  if (document.contains("sampling")) document["sampling"].erase("spp");
  document.erase("$schema");
  document["film"] = {settings.width,   settings.height,  settings.crop.x0,
                      settings.crop.y0, settings.crop.x1, settings.crop.y1};
  document["sampling"]["seed"] = settings.seed;
  document["channels"] = !settings.channels.empty();
  document["spectral_bins"] = settings.spectral_bins;
  document["fresnel"] = overrides.fresnel;
  document["karat"] = KARAT_VERSION;
  return hash_of(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Scene build_scene(const Json& json, const std::vector<ChangedPlace>& changes,
                  const std::string& name, const std::string& directory,
                  const SceneOverrides& overrides) {
  const JsonValue document(json, name, "", &changes);
  document.allow_keys(kSections);
  if (document.has("$schema")) document.member("$schema").string();
  Scene scene;
  scene.file = name;
  scene.files.push_back(name);
  scene.lattice = WavelengthLattice(read_wavelengths(document));
  scene.settings = read_settings(document, overrides);
  require_white(document, scene.settings);
  require_fresnel(overrides.fresnel);
  scene.content_hash = content_hash(json, scene.settings, overrides);
  const ReadContext context{directory,
                            scene.lattice.range(),
                            read_range_policy(document),
                            scene.settings.observer,
                            &scene.warnings,
                            &scene.tables,
                            interpolation_named(scene.settings.interpolation),
                            &scene.files};
  SceneBuilder(scene, context, overrides.fresnel).build(document);
  if (const auto violation = schema_violation(json); !violation.empty()) {
    throw InputError(name, "", "does not conform to the schema: " + violation);
  }
  return scene;
}

}  // namespace

Scene load_scene_text(const std::string& text, const std::string& name,
                      const std::string& directory, const SceneOverrides& overrides) {
  Json document = parse_json(text, name);
  std::vector<ChangedPlace> changes;
  if (!overrides.values.empty()) {
    changes = apply_overrides(document, scene_schema_json(), overrides.values);
  }
  return build_scene(document, changes, name, directory, overrides);
}

Scene load_scene(const std::string& path, const SceneOverrides& overrides) {
  const std::string text = read_text_file(path, kMaxSceneBytes);
  return load_scene_text(text, path, std::filesystem::path(path).parent_path().string(), overrides);
}

}  // namespace karat
