#include "apps/karat/fresnel/fit_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "materials/index/index_catalogue.h"
#include "render/replace_file.h"
#include "render/scene_settings.h"
#include "render/spectrum_reader.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Air in place of vacuum changes reflectances by less than the models' errors.
constexpr double kSameExterior = 1e-3;
// An exterior whose n varies by more than this deserves a word, as the fit takes one number.
constexpr double kDispersiveExterior = 1e-2;

// What a scene says to use these values.
OrderedJson scene_choice(const std::string& model, const FresnelFits& fits) {
  OrderedJson parameters;
  for (std::size_t p = 0; p < fits.parameters.size(); ++p) {
    OrderedJson& value = parameters[fits.parameters[p].name];
    if (!fits.per_wavelength) {
      value = fits.fits[0].values[p];
      continue;
    }
    OrderedJson rows = OrderedJson::array();
    for (std::size_t i = 0; i < fits.fits.size(); ++i) {
      rows.push_back({fits.wavelengths_nm[i], fits.fits[i].values[p]});
    }
    value["table"] = rows;
  }
  return {{"model", model}, {"parameters", parameters}};
}

// The file of the table that a scene's string names, as a scene would find it, or as it would be
// typed; "" where it names none.
std::string table_file(const std::string& name, const std::string& directory) {
  std::error_code error;
  const std::filesystem::path beside = std::filesystem::path(directory) / name;
  try {
    const bool is_file = std::filesystem::is_regular_file(beside, error);
    return find_index_table(is_file ? beside.string() : full_index_name(name))->provenance().file;
  } catch (const InputError&) {
    return "";
  }
}

// The checks of one scene.
class SceneCheck {
 public:
  SceneCheck(const JsonValue& scene, const PlannedFit& plan, std::vector<std::string>& warnings)
      : scene_(scene),
        plan_(plan),
        context_{std::filesystem::path(scene.file()).parent_path().string(),
                 read_wavelengths(scene),
                 read_range_policy(scene),
                 "cie1931",
                 &ignored_warnings_,
                 &ignored_tables_,
                 Interpolation::kLinear},
        warnings_(warnings) {}

  void require_wavelengths() const {
    if (plan_.per_wavelength && plan_.wavelengths_nm.size() == 1) {
      throw InputError(
          scene_.file(), "",
          fmt::format("a fit at {:g} nm alone would hold for {:g} to {:g} nm, the "
                      "wavelengths of the scene: say --over-range for one set of "
                      "values, or --nm with that range",
                      plan_.wavelengths_nm[0], context_.range.min_nm, context_.range.max_nm));
    }
    const WavelengthRange fitted{plan_.wavelengths_nm.front(), plan_.wavelengths_nm.back()};
    if (fitted.covers(context_.range) || plan_.over_range) return;
    const std::string found =
        fmt::format("the fit is for {:g} to {:g} nm, the scene's wavelengths are {:g} to {:g} nm",
                    fitted.min_nm, fitted.max_nm, context_.range.min_nm, context_.range.max_nm);
    if (context_.policy == RangePolicy::kError) {
      throw InputError(scene_.file(), "",
                       found +
                           "; fit all of them with --nm, or say --over-range for one set of "
                           "values");
    }
    warnings_.push_back(found + ": the values at its ends are held");
  }

  // The conductors that are made of the table.
  std::vector<std::string> made_of_table() const {
    std::vector<std::string> found, others;
    for (const std::string& name : conductors()) {
      const JsonValue material = scene_.member("materials").member(name);
      if (!material.has("nk")) continue;
      if (is_table(material.member("nk"))) {
        require_exterior(material, false);
        found.push_back(name);
      } else {
        others.push_back(fmt::format("{} ({})", name, shown(material.member("nk").json())));
      }
    }
    if (!found.empty()) return found;
    scene_.member("materials")
        .fail(fmt::format(
            "no conductor has \"nk\": \"{}\"{}; name one with --material",
            plan_.table->provenance().name,
            others.empty() ? "" : fmt::format("; there are {}", fmt::join(others, ", "))));
  }

  void require_material(const std::string& name) const {
    const std::vector<std::string> known = conductors();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      scene_.member("materials").fail(unknown_name_message("conductor", name, known));
    }
    const JsonValue material = scene_.member("materials").member(name);
    require_exterior(material, true);
    const JsonValue nk = material.member("nk");
    if (is_table(nk)) return;
    const std::string& fitted = plan_.table->provenance().name;
    if (nk.json().is_string()) {
      nk.fail(
          fmt::format("is {}, the fit is for \"{}\": values of one metal are wrong for another; "
                      "fit this one, or another --material",
                      shown(nk.json()), fitted));
    }
    if (nk.has("layers")) nk.fail("is a stack of thin films, which has its own exact Fresnel term");
    warnings_.push_back(fmt::format("\"{}\" has \"nk\": {}; the values written are those of \"{}\"",
                                    name, shown(nk.json()), fitted));
  }

 private:
  std::vector<std::string> conductors() const {
    std::vector<std::string> names;
    const JsonValue materials = scene_.member("materials");
    for (const std::string& name : materials.require_object().keys()) {
      const JsonValue material = materials.member(name);
      if (material.has("type") && material.member("type").json() == "conductor") {
        names.push_back(name);
      }
    }
    return names;
  }

  bool is_table(const JsonValue& nk) const {
    if (!nk.json().is_string()) return false;
    const std::string file = table_file(nk.string(), context_.directory);
    return !file.empty() && same_file(file, plan_.table->provenance().file);
  }

  void require_exterior(const JsonValue& material, bool named) const {
    double least = 1.0, largest = 1.0;
    if (material.has("exterior")) {
      const IndexTablePtr outside = read_index(material.member("exterior"), context_);
      least = largest = outside->at(plan_.wavelengths_nm.front()).n;
      for (const double nm : plan_.wavelengths_nm) {
        least = std::min(least, outside->at(nm).n), largest = std::max(largest, outside->at(nm).n);
      }
    }
    const std::string n =
        least == largest ? fmt::format("{:g}", least) : fmt::format("{:g} to {:g}", least, largest);
    if (plan_.n_exterior < least * (1.0 - kSameExterior) ||
        plan_.n_exterior > largest * (1.0 + kSameExterior)) {
      material.fail(fmt::format("its exterior{} has n = {}, the fit is for --n-exterior {:g}{}",
                                material.has("exterior") ? "" : " (vacuum)", n, plan_.n_exterior,
                                named ? "" : "; --material chooses another"));
    }
    if (largest > least * (1.0 + kDispersiveExterior)) {
      warnings_.push_back(fmt::format("{}: its exterior has n = {}, the fit is for {:g} alone",
                                      material.place(), n, plan_.n_exterior));
    }
  }

  const JsonValue& scene_;
  const PlannedFit& plan_;
  mutable std::vector<std::string> ignored_warnings_;
  mutable std::vector<Provenance> ignored_tables_;
  ReadContext context_;
  std::vector<std::string>& warnings_;
};

}  // namespace

FitScene::FitScene(const std::string& input, const std::string& material, const PlannedFit& plan) {
  const std::string text = read_text_file(input, kMaxSceneBytes);
  const Json json = parse_json(text, input);
  const JsonValue scene(json, input);
  const SceneCheck check(scene, plan, warnings_);
  if (material.empty()) {
    materials_ = check.made_of_table();
  } else {
    check.require_material(material);
    materials_ = {material};
  }
  check.require_wavelengths();
  scene_ = OrderedJson::parse(text);
}

void FitScene::write(const std::string& output, const std::string& model, const FresnelFits& fits) {
  for (const std::string& name : materials_) {
    scene_["materials"][name]["fresnel"] = scene_choice(model, fits);
  }
  replace_file(output, [&](const std::string& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file << scene_.dump(2) << '\n';
    if (!file.flush()) throw RuntimeError(errno ? std::strerror(errno) : "the file is incomplete");
  });
}

}  // namespace karat
