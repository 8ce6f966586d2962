#include "render/scene_builder.h"

#include <fmt/format.h>

#include <cmath>

#include "render/parameter_reader.h"
#include "render/transform_reader.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// The registered type that `value` names under "type".
template <typename Type>
const Type& type_of(const JsonValue& value, const std::string& what) {
  const JsonValue name = value.require_object().member("type");
  const auto& registry = Registry<Type>::instance();
  return *registry.find(name.choice(what + " type", registry.names()));
}

// Calls `create`; an InputError without file gets the place of `value`.
template <typename Create>
auto created(const JsonValue& value, Create&& create) {
  try {
    return create();
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

Transform transform_of(const JsonValue& value) {
  return value.has("transform") ? read_transform(value.member("transform")) : Transform{};
}

// A list under `key`; nothing where the key is absent.
std::vector<JsonValue> elements(const JsonValue& document, const std::string& key) {
  std::vector<JsonValue> values;
  if (!document.has(key)) return values;
  const JsonValue list = document.member(key);
  list.require_array();
  for (std::size_t i = 0; i < list.size(); ++i) values.push_back(list.element(i));
  return values;
}

std::vector<std::pair<std::string, JsonValue>> members(const JsonValue& document,
                                                       const std::string& key) {
  std::vector<std::pair<std::string, JsonValue>> values;
  if (!document.has(key)) return values;
  const JsonValue object = document.member(key);
  for (const auto& name : object.require_object().keys()) {
    values.emplace_back(name, object.member(name));
  }
  return values;
}

}  // namespace

SceneBuilder::SceneBuilder(Scene& scene, const ReadContext& context, std::string fresnel_override)
    : scene_(scene), context_(context), fresnel_override_(std::move(fresnel_override)) {}

void SceneBuilder::build(const JsonValue& document) {
  read_camera(document);
  read_materials(document);
  read_shapes(document);
  read_groups(document);
  read_lights(document);
  warn_if_black();
  scene_.fresnel = fmt::format("{}", fmt::join(fresnel_models_, ", "));
  scene_.finish();
}

void SceneBuilder::read_camera(const JsonValue& document) {
  const JsonValue value = document.member("camera");
  const auto& type = type_of<CameraType>(value, "camera");
  const Parameters parameters = read_parameters(value, type.parameters(), {"type"}, context_);
  scene_.camera = created(value, [&] {
    return type.create(parameters, scene_.settings.width, scene_.settings.height);
  });
}

void SceneBuilder::read_materials(const JsonValue& document) {
  std::map<std::string, std::vector<std::string>> places_of_warning;  // one line for all of them
  for (const auto& [name, value] : members(document, "materials")) {
    const auto& type = type_of<MaterialType>(value, "material");
    const auto infos = type.parameters();
    const Parameters parameters = read_parameters(value, infos, {"type"}, context_);
    for (const auto& info : infos) {
      if (info.name != "fresnel" || !parameters.has(info.name)) continue;
      fresnel_models_.insert(fresnel_override_.empty() ? parameters.fresnel(info.name).model
                                                       : fresnel_override_);
    }
    std::vector<std::string> warnings;
    const MaterialContext context{scene_.lattice, fresnel_override_, &warnings};
    scene_.materials.push_back(created(value, [&] { return type.create(parameters, context); }));
    for (const auto& warning : warnings) places_of_warning[warning].push_back(value.place());
    materials_[name] = scene_.materials.back().get();
  }
  for (const auto& [warning, places] : places_of_warning) {
    context_.warnings->push_back(fmt::format("{}: {}", fmt::join(places, ", "), warning));
  }
}

const Material* SceneBuilder::find_material(const JsonValue& value) const {
  const auto it = materials_.find(value.string());
  if (it != materials_.end()) return it->second;
  std::vector<std::string> names;
  for (const auto& entry : materials_) names.push_back(entry.first);
  value.fail(unknown_name_message("material", value.string(), names));
}

SceneBuilder::PlacedShape SceneBuilder::read_shape(const JsonValue& value) {
  const auto& type = type_of<ShapeType>(value, "shape");
  const Parameters parameters =
      read_parameters(value, type.parameters(),
                      {"type", "material", "transform", "emission", "two_sided"}, context_);
  PlacedShape shape;
  shape.surface.id = next_id_++;
  if (value.has("material")) {
    shape.surface.material = find_material(value.member("material"));
    any_material_scatters_ |= !shape.surface.material->only_delta();
  } else if (!value.has("emission")) {
    value.fail("\"material\" is missing (only a shape with \"emission\" may be without)");
  }
  const Transform transform = transform_of(value);
  shape.geometry = created(value, [&] { return transformed(type.create(parameters), transform); });
  const double area = surface_area(shape.geometry);
  if (!(area > 0.0) || !std::isfinite(area)) {
    value.fail(
        fmt::format("the shape has an area of {:g}: its size or transform is out of reach", area));
  }
  any_surface_ = true;
  return shape;
}

void SceneBuilder::add_emission(PlacedShape& shape, const JsonValue& value) {
  if (!value.has("emission")) {
    if (value.has("two_sided")) value.member("two_sided").fail("needs \"emission\" beside it");
    return;
  }
  const SpectrumPtr emission = read_emission(value.member("emission"), context_);
  const bool two_sided = value.has("two_sided") && value.member("two_sided").boolean();
  const LatticeSpectrum radiance = bin_means(*emission, scene_.lattice);
  scene_.lights.push_back(
      created(value, [&] { return make_area_light(shape.geometry, radiance, two_sided); }));
  shape.surface.light = scene_.lights.back().get();
}

void SceneBuilder::read_shapes(const JsonValue& document) {
  for (const JsonValue& value : elements(document, "shapes")) {
    PlacedShape shape = read_shape(value);
    add_emission(shape, value);
    scene_.world.add(std::move(shape.geometry), shape.surface);
  }
}

void SceneBuilder::read_groups(const JsonValue& document) {
  std::map<std::string, std::vector<Transform>> placements;
  std::vector<std::string> names;
  for (const auto& entry : members(document, "groups")) names.push_back(entry.first);
  for (const JsonValue& value : elements(document, "instances")) {
    value.allow_keys({"group", "transform"});
    const std::string& name = value.member("group").choice("group", names);
    placements[name].push_back(transform_of(value));
  }
  for (const auto& [name, group] : members(document, "groups")) {
    std::vector<World::Placed> shapes;
    group.require_array();
    for (std::size_t i = 0; i < group.size(); ++i) {
      const JsonValue value = group.element(i);
      for (const char* key : {"emission", "two_sided"}) {
        if (value.has(key))
          value.member(key).fail("shapes of a group cannot emit; put the lamp into \"shapes\"");
      }
      PlacedShape shape = read_shape(value);
      shapes.push_back({std::move(shape.geometry), shape.surface});
    }
    if (const auto it = placements.find(name); it != placements.end() && !shapes.empty()) {
      scene_.world.add_instances(std::move(shapes), it->second);
    } else {
      context_.warnings->push_back(group.place() + ": the group is " +
                                   (shapes.empty() ? "empty" : "never placed by \"instances\""));
    }
  }
}

void SceneBuilder::read_lights(const JsonValue& document) {
  for (const JsonValue& value : elements(document, "lights")) {
    const auto& type = type_of<LightType>(value, "light");
    const Parameters parameters =
        read_parameters(value, type.parameters(), {"type", "transform"}, context_);
    const LightContext context{scene_.lattice, transform_of(value), context_.warnings};
    scene_.lights.push_back(created(value, [&] { return type.create(parameters, context); }));
  }
}

// A black image is a legal answer, but seldom the one that was wanted: say what makes it black.
void SceneBuilder::warn_if_black() {
  bool only_delta_lights = true, any_power = false;
  for (const auto& light : scene_.lights) {
    only_delta_lights &= light->is_delta();
    any_power |= light->power(1.0f) > 0.0f;
  }
  if (scene_.lights.empty()) {
    context_.warnings->push_back(
        "the image will be black: the scene has no \"lights\" and no shape with \"emission\"");
  } else if (!any_power) {
    context_.warnings->push_back("the image will be black: every light and emission is zero");
  } else if (!any_surface_ && only_delta_lights) {
    context_.warnings->push_back(
        "the image will be black: there are no shapes, and point-like lights cannot be seen");
  } else if (only_delta_lights && !any_material_scatters_) {
    context_.warnings->push_back(
        "the image will be black: all materials are perfectly smooth and all lights are points or "
        "directions, so no path can join them; use a lamp with an area, an environment, or alpha > "
        "0");
  }
}

}  // namespace karat
