// Spectra and complex indices in scene files.
#pragma once

#include <string>
#include <vector>

#include "materials/index/index_interpolation.h"
#include "materials/index/index_table.h"
#include "render/scene_json.h"
#include "spectral/spectrum.h"

namespace karat {

// What reading a scene needs to know, and what it collects.
struct ReadContext {
  std::string
      directory;  // of the scene file: relative paths start here, then in the working folder
  WavelengthRange range = kVisible;
  RangePolicy policy = RangePolicy::kError;
  std::string observer = "cie1931";
  std::vector<std::string>* warnings = nullptr;  // never null
  std::vector<Provenance>* tables = nullptr;     // never null; every index table read, once each
  Interpolation interpolation = Interpolation::kLinear;  // of index tables
  std::vector<std::string>* files = nullptr;             // unless null: every file read is added
  int preset_depth = 0;                                  // of alloys' presets within each other
};

// Adds a file to those that the scene was read from.
void remember_file(const std::string& path, const ReadContext& context);

// The path, absolute, of a file named in a scene (scene_path.h); fails where there is no such file.
std::string read_path(const JsonValue& value, const ReadContext& context);

// A number, {"rgb": [r, g, b]} (smooth spectrum of that linear sRGB colour), {"table": [[nm,
// value],
// ...]}, {"file": "x.spd"} (spectrum_columns.h); with "scale". Values outside [0, 1] are an error.
SpectrumPtr read_reflectance(const JsonValue& value, const ReadContext& context);

// As above, without upper limit, and {"illuminant": NAME}, {"blackbody": kelvin}, {"rgb": ...,
// "illuminant": NAME}. "scale" multiplies; "luminance" instead scales the whole so that
// integral(L ybar) / integral(ybar) is that number. An illuminant, and the white of an rgb, has
// luminance 1 before "scale"; a blackbody is Planck's radiance, in W m^-2 sr^-1 nm^-1.
SpectrumPtr read_emission(const JsonValue& value, const ReadContext& context);

// A number, {"table": [[nm, value], ...]} or {"file": "x.spd"}, of either sign and without a unit.
SpectrumPtr read_plain_spectrum(const JsonValue& value, const ReadContext& context);

// Adds a table to those of the image's metadata, once.
void collect(const Provenance& provenance, const ReadContext& context);

// "main/Au/Johnson" or the path of an index file, a number n, {"eta": spectrum, "k": spectrum}, or
// what index_reader.h lists: alloys, tables between tables, formulas, thin films on a substrate.
// The table covers the scene's wavelengths, or fails (warns under "clamp").
IndexTablePtr read_index(const JsonValue& value, const ReadContext& context);

// Fails, or warns under "clamp", when `spectrum` is not known over the scene's wavelengths.
void require_spectrum_coverage(const Spectrum& spectrum, const JsonValue& value,
                               const ReadContext& context);

}  // namespace karat
