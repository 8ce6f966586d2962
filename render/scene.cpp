#include "render/scene.h"

namespace karat {

void Scene::finish() {
  world.commit();
  Vec3 center;
  float radius = 0.0f;
  world.bounding_sphere(center, radius);
  light_selection = LightSelection(lights, radius);
  environments.clear();
  for (const auto& light : lights) {
    if (light->is_environment()) environments.push_back(light.get());
  }
}

}  // namespace karat
