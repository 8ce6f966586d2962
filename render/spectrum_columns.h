// Spectra from text files of two columns.
#pragma once

#include <string>
#include <vector>

#include "render/scene_json.h"
#include "spectral/spectrum.h"

namespace karat {

// The spectrum of a file's text: wavelength and value, separated by blanks, tabs, commas or
// semicolons, with decimal points or commas; lines above the rows may name the columns, "Wavelength
// (um)" their unit (nm unless said); "#" begins a comment. Rows may run backwards. `file` stands in
// messages. Throws InputError with file and line: what is no such row, or a value not `allowed`.
SpectrumPtr spectrum_of_text(const std::string& text, const std::string& file,
                             const Allowed& allowed);

// Linear between rows. Throws InputError for no rows, and wavelengths that do not increase.
SpectrumPtr spectrum_of_rows(const std::vector<SpectrumSample>& rows, std::string description);

}  // namespace karat
