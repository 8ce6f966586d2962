// The report: one page with its numbers, its script, its styles and D3 in it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "apps/karat/embedded_file.h"
#include "apps/karat/fresnel/study_report.h"
#include "apps/karat/swatch.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Json = nlohmann::ordered_json;

// At most so many wavelengths go into the page's charts; the CSV files hold all.
constexpr std::size_t kPageWavelengths = 48;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? bytes[i + j] : 0);
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? kLetters[group >> (18 - 6 * j) & 63] : '=';
    }
  }
  return text;
}

std::string png_url(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RuntimeError(path + ": cannot be read");
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return "data:image/png;base64," + base64({bytes.begin(), bytes.end()});
}

// Little-endian integers of two bytes.
std::string packed(const std::vector<double>& values, double scale) {
  std::vector<std::uint8_t> bytes;
  for (const double value : values) {
    const auto word = static_cast<std::uint16_t>(std::lround(value * scale));
    bytes.push_back(static_cast<std::uint8_t>(word & 255));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8));
  }
  return base64(bytes);
}

class Page {
 public:
  explicit Page(const StudyReport& report)
      : report_(report), stride_(1 + report.options.grid.wavelengths_nm.size() / kPageWavelengths) {
    for (const double wanted : {0.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0}) {
      const auto& angles = report.options.grid.angles_deg;
      const auto found = std::find(angles.begin(), angles.end(), wanted);
      if (found != angles.end())
        swatch_angles_.push_back(static_cast<std::size_t>(found - angles.begin()));
    }
  }

  Json json() const {
    const FresnelGrid& grid = report_.options.grid;
    Json page = {{"stride", stride_},
                 {"wavelengths_nm", thinned(grid.wavelengths_nm)},
                 {"angles_deg", grid.angles_deg},
                 {"swatch_angles_deg", Json::array()},
                 {"same", {{"cost", kSameCost}, {"error", kSameError}, {"floor", kNoError}}},
                 {"materials", Json::array()}};
    for (const std::size_t a : swatch_angles_)
      page["swatch_angles_deg"].push_back(grid.angles_deg[a]);
    for (const auto& material : report_.materials)
      page["materials"].push_back(material_json(material));
    return page;
  }

 private:
  // Every stride-th wavelength.
  std::vector<double> thinned(const std::vector<double>& values) const {
    const std::size_t wavelengths = report_.options.grid.wavelengths_nm.size();
    std::vector<double> kept;
    for (std::size_t row = 0; row < values.size(); row += wavelengths) {
      for (std::size_t i = 0; i < wavelengths; i += stride_) kept.push_back(values[row + i]);
    }
    return kept;
  }

  static std::vector<double> rounded(std::vector<double> values, double digits) {
    for (double& value : values) value = std::round(value * digits) / digits;
    return values;
  }

  std::vector<std::string> swatches(const FresnelColours& colours) const {
    std::vector<std::string> hex;
    for (const std::size_t a : swatch_angles_) {
      hex.push_back(display_hex(linear_srgb_of_xyz(colours.per_angle[a])));
    }
    hex.push_back(display_hex(linear_srgb_of_xyz(colours.albedo)));
    return hex;
  }

  // Model minus exact, in steps of its largest value over 32767; null where a model has none.
  Json difference(const GridValues& model, const GridValues& exact) const {
    if (model.empty()) return nullptr;
    std::vector<double> errors = thinned(model);
    const std::vector<double> reference = thinned(exact);
    double largest = 1e-30;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i] -= reference[i];
      largest = std::max(largest, std::abs(errors[i]));
    }
    return {{"step", largest / 32767.0}, {"values", packed(errors, 32767.0 / largest)}};
  }

  Json material_json(const FresnelMaterialStudy& material) const {
    Json json = {{"exact",
                  {{"u", packed(thinned(material.exact.unpolarised), 65535.0)},
                   {"s", packed(thinned(material.exact.s), 65535.0)},
                   {"p", packed(thinned(material.exact.p), 65535.0)},
                   {"albedo", rounded(material.exact.albedo, 1e7)},
                   {"swatches", swatches(material.colours)}}},
                 {"models", Json::array()}};
    for (const auto& study : material.models) {
      json["models"].push_back(
          {{"u", difference(study.curves.unpolarised, material.exact.unpolarised)},
           {"s", difference(study.curves.s, material.exact.s)},
           {"p", difference(study.curves.p, material.exact.p)},
           {"albedo", rounded(study.curves.albedo, 1e7)},
           {"delta_e", rounded(study.colour_error.delta_e, 1e5)},
           {"swatches", swatches(study.colours)}});
    }
    return json;
  }

  const StudyReport& report_;
  std::size_t stride_;
  std::vector<std::size_t> swatch_angles_;
};

void replace(std::string& text, const std::string& mark, std::string_view value) {
  const std::size_t place = text.find(mark);
  if (place != std::string::npos) text.replace(place, mark.size(), value);
}

// "</script>" inside a script would end it.
std::string inside_script(std::string text) {
  for (std::size_t i = text.find("</"); i != std::string::npos; i = text.find("</", i + 3)) {
    text.replace(i, 2, "<\\/");
  }
  return text;
}

}  // namespace

void write_study_html(const std::string& folder, const StudyReport& report) {
  const std::string file = folder + "/index.html";
  Json data = {{"study", study_json(report)}, {"page", Page(report).json()}};
  if (report.renders) {
    Json& render = data["study"]["render"];
    render["colour_bar"] = png_url(folder + "/pictures/scale.png");
    for (Json& model : render["models"]) {
      const std::string name = folder + "/pictures/" + model["model"].get<std::string>();
      model["picture"] = png_url(name + ".png");
      model["difference"] = png_url(name + "-difference.png");
    }
  }
  std::string page(embedded_file("study.html"));
  replace(page, "{{style}}", embedded_file("study.css"));
  replace(page, "{{charts}}", embedded_file("charts.js"));
  replace(page, "{{script}}", embedded_file("study.js"));
  replace(page, "{{d3}}", embedded_file("d3.min.js"));
  replace(page, "{{data}}",
          inside_script(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  replace_file(file, [&](const std::string& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << page;
    if (!out.flush()) throw RuntimeError(file + ": cannot be written");
  });
}

}  // namespace karat
