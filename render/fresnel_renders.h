// One scene rendered with one Fresnel model after the other: what an approximation changes in a
// picture, and how much time it saves of a whole render.
//
// All models use the same random numbers. They take turns in random order, some samples each, so
// that whatever else the machine does meets all of them alike; time is that of the processors, over
// all threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/fresnel_study/fresnel_cost.h"
#include "render/image_file.h"

namespace karat {

struct FresnelRenderOptions {
  std::string scene;                          // file
  std::vector<std::string> models;            // "exact" is rendered whether asked for or not
  int width = 0, height = 0;                  // 0: the scene's own
  int spp = 64;                               // samples per pixel
  int rounds = 8;                             // turns; every round adds spp / rounds samples
  int threads = 0;                            // 0: all
  std::function<void(double done)> progress;  // in [0, 1]
};

// CIEDE2000 per pixel between two pictures as a display shows them (linear sRGB clamped to [0, 1]).
struct PictureDifference {
  std::vector<float> delta_e;  // row by row from the top
  double mean = 0.0, p95 = 0.0, max = 0.0;
};
PictureDifference picture_difference(const Image& a, const Image& b);

struct FresnelRender {
  std::string model;
  Image picture;                 // linear sRGB, white D65
  PictureDifference difference;  // from exact
  CostSpread relative_time;      // of the whole render, to exact in the same round
  double cpu_seconds = 0.0;      // all samples
};

struct FresnelRenders {
  int width = 0, height = 0, spp = 0;
  std::vector<FresnelRender> models;  // "exact" first
  // Of a second render with exact and other random numbers: what differs by less is noise.
  PictureDifference noise;
  CostSpread noise_time;
  // The part of the render's time that the exact model takes: from renders in which it is evaluated
  // 65 times at every place, and paths stay what they are.
  CostSpread fresnel_share;
  double evaluations_per_sample = 0.0;  // calls for all wavelengths, per camera sample
};

// Throws InputError for an unknown model, and what load_scene throws.
FresnelRenders render_fresnel_models(const FresnelRenderOptions& options);

}  // namespace karat
