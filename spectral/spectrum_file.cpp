#include "spectral/spectrum_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::uintmax_t kMostBytes = 4u << 20;
constexpr std::size_t kMostSamples = 100000;

class ZeroOutsideSpectrum final : public Spectrum {
 public:
  explicit ZeroOutsideSpectrum(SpectrumPtr spectrum)
      : spectrum_(std::move(spectrum)), range_(spectrum_->range()) {}

  double operator()(double nm) const override {
    return nm < range_.min_nm || nm > range_.max_nm ? 0.0 : (*spectrum_)(nm);
  }
  double mean(WavelengthRange interval) const override {
    if (!(interval.width_nm() > 0.0)) return (*this)(interval.min_nm);
    const WavelengthRange inside{std::max(interval.min_nm, range_.min_nm),
                                 std::min(interval.max_nm, range_.max_nm)};
    if (!(inside.width_nm() > 0.0)) return 0.0;
    return spectrum_->mean(inside) * (inside.width_nm() / interval.width_nm());
  }
  WavelengthRange range() const override { return range_; }
  std::string description() const override { return spectrum_->description(); }

 private:
  SpectrumPtr spectrum_;
  WavelengthRange range_;
};

nlohmann::json parsed(const std::string& path) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  if (error) throw InputError(path, "", "cannot be read: " + error.message());
  if (bytes > kMostBytes) throw InputError(path, "", "is larger than 4 MiB");
  std::ifstream file(path);
  try {
    return nlohmann::json::parse(file);
  } catch (const nlohmann::json::exception& e) {
    throw InputError(path, "", e.what());
  }
}

const nlohmann::json* member(const nlohmann::json& json, const std::string& key) {
  const nlohmann::json::json_pointer pointer("/" + key);
  return json.contains(pointer) ? &json[pointer] : nullptr;
}

}  // namespace

SpectrumFile::SpectrumFile(std::string path)
    : path_(std::move(path)), json_(std::make_unique<const nlohmann::json>(parsed(path_))) {
  if (!json_->is_object()) throw InputError(path_, "", "must hold one JSON object");
}
SpectrumFile::~SpectrumFile() = default;
SpectrumFile::SpectrumFile(SpectrumFile&&) noexcept = default;

void SpectrumFile::fail(const std::string& key, const std::string& message) const {
  throw InputError(path_, key, message);
}

bool SpectrumFile::has(const std::string& key) const { return member(*json_, key) != nullptr; }

std::string SpectrumFile::text(const std::string& key) const {
  const auto* value = member(*json_, key);
  if (!value || !value->is_string()) fail(key, "must be a text");
  return value->get<std::string>();
}

double SpectrumFile::number(const std::string& key) const {
  const auto* value = member(*json_, key);
  if (!value || !value->is_number()) fail(key, "must be a number");
  const double number = value->get<double>();
  if (!std::isfinite(number)) fail(key, "must be finite");
  return number;
}

std::vector<double> SpectrumFile::array(const std::string& key) const {
  const auto* values = member(*json_, key);
  if (!values || !values->is_array() || values->empty()) fail(key, "must be an array of numbers");
  if (values->size() > kMostSamples) fail(key, "has more than 100000 numbers");
  std::vector<double> numbers;
  numbers.reserve(values->size());
  for (const auto& value : *values) {
    const std::string place = key + "/" + std::to_string(numbers.size());
    if (!value.is_number()) fail(place, "must be a number");
    numbers.push_back(value.get<double>());
    if (!std::isfinite(numbers.back())) fail(place, "must be finite");
  }
  return numbers;
}

SpectrumPtr SpectrumFile::table(const std::string& key, std::string description) const {
  const double start = number("wavelength_nm/start"), step = number("wavelength_nm/step");
  if (!(start > 0.0 && start <= 1e6)) fail("wavelength_nm/start", "must lie above 0, up to 1e6");
  if (!(step >= 1e-3 && step <= 1e3)) fail("wavelength_nm/step", "must lie within 0.001 and 1000");
  std::vector<double> values = array(key);
  std::vector<double> wavelengths_nm(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    wavelengths_nm[i] = start + static_cast<double>(i) * step;
  }
  return zero_outside_range(
      table_spectrum(std::move(wavelengths_nm), std::move(values), std::move(description)));
}

SpectrumPtr zero_outside_range(SpectrumPtr spectrum) {
  return std::make_shared<ZeroOutsideSpectrum>(std::move(spectrum));
}

std::vector<std::string> data_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data_path(folder))) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string named_data_file(const std::string& folder, const std::string& what,
                            const std::string& name) {
  const std::vector<std::string> names = data_names(folder);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError(unknown_name_message(what, name, names));
  }
  return data_path(folder) + "/" + name + ".json";
}

}  // namespace karat
