// A loaded scene: everything that rendering reads, immutable once loaded.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "materials/index/index_table.h"
#include "materials/material.h"
#include "render/camera.h"
#include "render/light.h"
#include "render/light_selection.h"
#include "render/world.h"

namespace karat {

// Pixels [x0, x1) x [y0, y1) of the image.
struct Crop {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct RenderSettings {
  int width = 512, height = 512;
  Crop crop{0, 0, 512, 512};
  int spp = 16;
  std::uint32_t seed = 0;
  std::string sampler = "sobol";         // or "independent"
  std::string integrator = "path";       // name in the Registry<Integrator>
  int max_depth = 16;                    // scattering events along a path
  std::string observer = "cie1931";      // or "cie1964"
  std::string white = "D65";             // "D65", "E", a temperature in kelvin, or "none"
  std::string interpolation = "linear";  // of index tables, or "monotone-cubic"
  std::vector<std::string> channels;     // feature channels ("albedo", "normal", ...)
  int spectral_bins = 0;                 // 0: no spectral image
};

struct Scene {
  std::string file;
  std::vector<std::string> files;  // everything that was read: scene, meshes, images, tables
  std::uint64_t content_hash = 0;  // of everything that decides the image: checkpoints carry it
  WavelengthLattice lattice;
  RenderSettings settings;
  std::unique_ptr<const Camera> camera;
  std::vector<std::unique_ptr<const Material>> materials;
  std::vector<std::unique_ptr<const Light>> lights;
  World world;
  LightSelection light_selection;  // over `lights`, set up by finish()
  std::vector<const Light*> environments;
  std::vector<Provenance> tables;  // every index table in use
  std::string fresnel;             // the models in use, for the metadata
  std::vector<std::string> warnings;

  // Commits the world and prepares what is derived from the lights. Called once by the loader.
  void finish();
};

}  // namespace karat
