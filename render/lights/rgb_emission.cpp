#include "render/lights/rgb_emission.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {

RgbEmission::RgbEmission(const WavelengthLattice& lattice) {
  const std::string path = data_path("rgb/rec709_emission.json");
  try {
    const nlohmann::json json = nlohmann::json::parse(std::ifstream(path));
    const double start = json.at("wavelength_nm").at("start");
    const double step = json.at("wavelength_nm").at("step");
    const auto read = [&](const char* name) {
      const auto values = json.at(name).get<std::vector<double>>();
      std::vector<double> wavelengths_nm;
      for (std::size_t i = 0; i < values.size(); ++i) {
        wavelengths_nm.push_back(start + step * static_cast<double>(i));
      }
      return bin_means(*table_spectrum(wavelengths_nm, values, name), lattice);
    };
    red = read("red");
    green = read("green");
    blue = read("blue");
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path, "", error.what());
  } catch (const std::invalid_argument& error) {
    throw InputError(path, "", error.what());
  }
}

}  // namespace karat
