// What a Fresnel model is worth on a material: its errors in reflectance and in colour.
//
// Computation only: no files, no text. Models run by the renderer's own kernel in single precision;
// they are measured against the exact equations in double precision, so that the model "exact"
// shows what rounding costs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/fresnel.h"
#include "spectral/colour.h"

namespace karat {

// Where errors are measured. Every point counts the same: statistics are unweighted.
struct FresnelGrid {
  std::vector<double> wavelengths_nm;  // increasing, at least one
  std::vector<double> angles_deg;      // increasing, in [0, 90]

  std::size_t size() const { return wavelengths_nm.size() * angles_deg.size(); }
  WavelengthRange range() const { return {wavelengths_nm.front(), wavelengths_nm.back()}; }
};

// 380 to 780 nm in steps of 5 nm, 0 to 89 degrees in steps of 1 degree.
FresnelGrid usual_fresnel_grid();

// Under what, and by whom, colours are seen.
struct FresnelViewing {
  std::string illuminant = "D65";
  std::string observer = "cie1931";
};

// Values over a grid: element `angle * wavelengths + wavelength`.
using GridValues = std::vector<double>;

// Reflectances over a grid. s and p are empty where a model knows only the unpolarised value.
struct FresnelCurves {
  GridValues unpolarised, s, p;
  std::vector<double> albedo;  // per wavelength, 2 integral F(c) c dc over [0, 1]
};

// Of model minus exact. Angle and wavelength of the largest absolute error.
struct FresnelErrors {
  double max_abs = 0.0, mean_abs = 0.0, rms = 0.0, mean_signed = 0.0;
  double worst_nm = 0.0, worst_deg = 0.0;
};

// Colours of a material, Y = 1 for the perfect reflector.
struct FresnelColours {
  std::vector<Xyz> per_angle;
  Xyz albedo{};  // of the hemispherical, cosine-weighted reflectance
};

// CIEDE2000 between two of these.
struct FresnelColourErrors {
  std::vector<double> delta_e;  // per angle
  double mean = 0.0, max = 0.0, worst_deg = 0.0;
  double albedo = 0.0;
};

// The exact equations in double precision. Throws InputError where the table does not cover the
// grid's wavelengths, or has a negative n or k there.
FresnelCurves exact_fresnel_curves(const IndexTable& table, const FresnelGrid& grid);

// A model, by the kernel that renders. The same errors.
FresnelCurves fresnel_curves(const FresnelModel& model, const IndexTable& table,
                             const FresnelGrid& grid);

FresnelErrors fresnel_errors(const GridValues& model, const GridValues& exact,
                             const FresnelGrid& grid);

// Sums at whole nanometres over the grid's wavelengths, between which reflectance is taken as
// linear. Throws InputError for an unknown illuminant or observer, and where it has no power.
FresnelColours fresnel_colours(const FresnelCurves& curves, const FresnelGrid& grid,
                               const FresnelViewing& viewing);

FresnelColourErrors fresnel_colour_errors(const FresnelColours& model, const FresnelColours& exact,
                                          const FresnelGrid& grid, const FresnelViewing& viewing);

// One model on one material.
struct FresnelModelStudy {
  std::string model;
  FresnelCurves curves;
  FresnelErrors error;
  FresnelColours colours;
  FresnelColourErrors colour_error;
  double albedo_max_abs_error = 0.0;  // over wavelengths
};

// Another measurement of the same material, seen through the exact equations: how far apart
// measurements are, against which a model's error can be weighed.
struct FresnelTableStudy {
  std::string table;
  FresnelErrors error;
  FresnelColourErrors colour_error;
};

struct FresnelMaterialStudy {
  IndexTablePtr table;
  FresnelCurves exact;
  FresnelColours colours;
  std::vector<FresnelModelStudy> models;        // in the order asked for
  std::vector<FresnelTableStudy> other_tables;  // in alphabetical order
};

struct FresnelStudyOptions {
  std::vector<std::string> tables;  // names of index tables
  std::vector<std::string> models;  // names in the Registry<FresnelModel>
  FresnelGrid grid = usual_fresnel_grid();
  FresnelViewing viewing;
};

// All models on all materials, on all threads. `after_each(done, total)` runs after every model on
// a material, on whatever thread, one call at a time. Throws InputError for unknown names, and as
// above.
std::vector<FresnelMaterialStudy> study_fresnel_models(
    const FresnelStudyOptions& options,
    const std::function<void(std::size_t done, std::size_t total)>& after_each = {});

}  // namespace karat
