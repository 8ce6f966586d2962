// Turns a checked scene document into a Scene, part by part.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/scene.h"
#include "render/scene_json.h"
#include "render/spectrum_reader.h"

namespace karat {

class SceneBuilder {
 public:
  // `scene` has its lattice and settings; `fresnel_override` as in MaterialContext. Both references
  // must outlive the builder.
  SceneBuilder(Scene& scene, const ReadContext& context, std::string fresnel_override);

  // Camera, materials, shapes, groups, instances and lights; then the scene as a whole is checked
  // and finished. Throws InputError.
  void build(const JsonValue& document);

 private:
  void read_camera(const JsonValue& document);
  void read_materials(const JsonValue& document);
  void read_shapes(const JsonValue& document);
  void read_groups(const JsonValue& document);
  void read_lights(const JsonValue& document);
  void warn_if_black();

  struct PlacedShape {
    Geometry geometry;
    Surface surface;
  };
  PlacedShape read_shape(const JsonValue& value);
  void add_emission(PlacedShape& shape, const JsonValue& value);
  const Material* find_material(const JsonValue& value) const;

  Scene& scene_;
  const ReadContext& context_;
  std::string fresnel_override_;
  std::map<std::string, const Material*> materials_;
  std::set<std::string> fresnel_models_;
  std::uint32_t next_id_ = 0;
  bool any_material_scatters_ = false;  // a used one that is not a delta alone
  bool any_surface_ = false;
};

}  // namespace karat
