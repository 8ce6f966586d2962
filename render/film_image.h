// From the film to images: scene-linear RGB with feature layers, and what the image says of itself.
#pragma once

#include "render/film.h"
#include "render/image_file.h"
#include "render/scene.h"

namespace karat {

// Linear Rec. 709 R, G, B of the film, adapted (CAT16) from the scene's white to D65, with the
// feature channels that the settings ask for as layers: albedo.R/G/B, normal.X/Y/Z, depth.Z,
// shape.id, samples.N, variance.Y (of the pixel's mean). Nothing is clamped.
Image film_image(const Scene& scene, const Film& film);

// Radiance in equal bins, W m^-2 sr^-1 nm^-1, in the layout of Fichet, Pacanowski and Wilkie, "An
// OpenEXR Layout for Spectral Images", JCGT 10(3), 2021, with R, G, B as preview. The film must
// have spectral bins.
Image spectral_image(const Scene& scene, const Film& film);

// What varies between runs that give the same pixels; left out where files must be equal too.
struct RunFacts {
  double seconds = 0.0;
  int threads = 0;
};

// Adds the image's provenance: version, scene, samples, seed, observer, white, index tables with
// their references, Fresnel models and warnings, as "karat:..." attributes.
void add_provenance(Image& image, const Scene& scene, int samples, const RunFacts* facts);

}  // namespace karat
