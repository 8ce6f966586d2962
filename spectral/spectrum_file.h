// The text files of data/cie and data/illuminants: spectra on an even grid of wavelengths, with
// their description, source and unit in the head. All of it is read at load time.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "spectral/spectrum.h"

namespace karat {

// One such file. Every reader throws InputError naming the file, the key and what is wrong.
class SpectrumFile {
 public:
  explicit SpectrumFile(std::string path);
  ~SpectrumFile();
  SpectrumFile(SpectrumFile&&) noexcept;

  bool has(const std::string& key) const;
  std::string text(const std::string& key) const;
  // A finite number; `key` may be a JSON pointer's inside, "planck/c2_nm_kelvin".
  double number(const std::string& key) const;

  // The array under `key` over the grid in "wavelength_nm", linear between samples and zero outside
  // the grid. (CIE tables end where their authors set the value to zero; a held end value would add
  // energy that nobody measured.)
  SpectrumPtr table(const std::string& key, std::string description) const;

 private:
  std::vector<double> array(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

  std::string path_;
  std::unique_ptr<const nlohmann::json> json_;
};

// `spectrum` inside its range, 0 outside; means are exact where those of `spectrum` are.
SpectrumPtr zero_outside_range(SpectrumPtr spectrum);

// The names of the files `*.json` directly in a folder of data/, without the ending, sorted.
std::vector<std::string> data_names(const std::string& folder);

// The path of data/FOLDER/NAME.json; throws InputError listing the names there ("unknown WHAT
// ...").
std::string named_data_file(const std::string& folder, const std::string& what,
                            const std::string& name);

}  // namespace karat
