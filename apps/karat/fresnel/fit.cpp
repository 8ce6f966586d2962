// karat fresnel fit: the free parameters of a Fresnel model for one material.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/fresnel/named_values.h"
#include "apps/karat/json_output.h"
#include "apps/karat/number_check.h"
#include "materials/fresnel_fit.h"
#include "materials/index_catalogue.h"
#include "render/image_file.h"
#include "render/scene_json.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Models = Registry<FresnelModel>;
using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kMostWavelengths = 10000;

struct Options {
  std::string page, model, wavelengths = "380:780:5";
  std::vector<std::string> fixed;
  double n_exterior = 1.0;
  bool over_range = false, as_json = false;
  std::string scene, material, output;
};

std::vector<double> numbers_of(const std::string& text, char separator) {
  std::vector<double> numbers;
  const char *at = text.data(), *end = at + text.size();
  while (true) {
    double number = 0.0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !(number > 0.0 && number <= 1e9)) return {};
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != separator) return {};
    at = next + 1;
  }
}

// "380:780:5", or "450,550,650"; empty where the text is neither.
std::vector<double> wavelengths_of(const std::string& text) {
  if (text.find(':') == std::string::npos) return numbers_of(text, ',');
  const std::vector<double> parts = numbers_of(text, ':');
  if (parts.size() != 3 || !(parts[0] <= parts[1])) return {};
  const double steps = std::floor((parts[1] - parts[0]) / parts[2] + 1e-9);
  if (!(steps < kMostWavelengths)) return {};
  std::vector<double> wavelengths;
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    wavelengths.push_back(parts[0] + parts[2] * i);
  }
  return wavelengths;
}

std::vector<double> angle_cosines() {
  std::vector<double> cosines;
  for (int degrees = 0; degrees < 90; ++degrees) {
    cosines.push_back(std::sin((90.0 - degrees) * (M_PI / 180.0)));
  }
  return cosines;
}

struct Fits {
  std::vector<FresnelParameter> parameters;
  std::vector<double> wavelengths_nm;
  std::vector<FresnelFit> fits;  // one a wavelength, or one for all
  double max_abs_error = 0.0, rms_error = 0.0;

  bool per_wavelength() const { return fits.size() == wavelengths_nm.size(); }
};

Fits fitted(const Options& options, const FresnelModel& model, const IndexTable& table) {
  Fits result{model.parameters(), wavelengths_of(options.wavelengths), {}, 0.0, 0.0};
  const auto [least, largest] =
      std::minmax_element(result.wavelengths_nm.begin(), result.wavelengths_nm.end());
  require_coverage(table, {*least, *largest}, RangePolicy::kError);
  std::vector<ComplexIndex> indices;
  for (const double nm : result.wavelengths_nm) {
    const ComplexIndex index = table.at(nm);
    if (!(index.n >= 0.0 && index.k >= 0.0)) {
      throw InputError(options.page, "",
                       fmt::format("n = {:g}, k = {:g} at {:g} nm; both must be 0 "
                                   "or above",
                                   index.n, index.k, nm));
    }
    indices.push_back({index.n / options.n_exterior, index.k / options.n_exterior});
  }
  bool per_material = options.over_range;
  for (const FresnelParameter& info : result.parameters) per_material |= info.per_material;
  const auto fixed = named_values(options.fixed);
  const auto add = [&](std::vector<ComplexIndex> chosen) {
    result.fits.push_back(
        fit_fresnel(model, exact_data(std::move(chosen), angle_cosines()), fixed));
  };
  if (per_material) {
    add(indices);
  } else {
    for (const ComplexIndex& index : indices) add({index});
  }
  for (const FresnelFit& fit : result.fits) {
    result.max_abs_error = std::max(result.max_abs_error, fit.max_abs_error);
    result.rms_error += fit.rms_error * fit.rms_error;
  }
  result.rms_error = std::sqrt(result.rms_error / static_cast<double>(result.fits.size()));
  return result;
}

OrderedJson fit_json(const Fits& fits, std::size_t i) {
  OrderedJson values;
  for (std::size_t p = 0; p < fits.parameters.size(); ++p) {
    values[fits.parameters[p].name] = fits.fits[i].values[p];
  }
  OrderedJson json;
  if (fits.per_wavelength()) json["nm"] = fits.wavelengths_nm[i];
  json["values"] = values;
  json["max_abs_error"] = fits.fits[i].max_abs_error;
  json["rms_error"] = fits.fits[i].rms_error;
  return json;
}

void print_as_json(const Options& options, const IndexTable& table, const Fits& fits) {
  OrderedJson parameters = OrderedJson::array(), list = OrderedJson::array();
  for (const FresnelParameter& info : fits.parameters) {
    parameters.push_back(
        {{"name", info.name}, {"description", info.description}, {"range", {info.min, info.max}}});
  }
  for (std::size_t i = 0; i < fits.fits.size(); ++i) list.push_back(fit_json(fits, i));
  print_json(OrderedJson{{"nk", table.provenance().name},
                         {"n_exterior", options.n_exterior},
                         {"model", options.model},
                         {"parameters", parameters},
                         {"angles_deg", "0:89:1"},
                         {"wavelengths_nm", fits.wavelengths_nm},
                         {"per_wavelength", fits.per_wavelength()},
                         {"fits", list},
                         {"max_abs_error", fits.max_abs_error},
                         {"rms_error", fits.rms_error}});
}

void print_line(const std::string& first, const FresnelFit& fit) {
  fmt::print("{:>16}", first);
  for (const double value : fit.values) fmt::print(" {:>12.6g}", value);
  fmt::print(" {:>11.3e} {:>11.3e}\n", fit.max_abs_error, fit.rms_error);
}

void print_table(const Options& options, const IndexTable& table, const Fits& fits) {
  fmt::print("{} of {} against the exact equations, 0 to 89 degrees in steps of 1\n", options.model,
             table.provenance().name);
  for (const FresnelParameter& info : fits.parameters) {
    fmt::print("  {}: {} ({:g} to {:g})\n", info.name, info.description, info.min, info.max);
  }
  fmt::print("\n{:>16}", "nm");
  for (const FresnelParameter& info : fits.parameters) fmt::print(" {:>12}", info.name);
  fmt::print(" {:>11} {:>11}\n", "max error", "RMS error");
  if (!fits.per_wavelength()) {
    print_line(fmt::format("{:g} to {:g}", fits.wavelengths_nm.front(), fits.wavelengths_nm.back()),
               fits.fits[0]);
    return;
  }
  for (std::size_t i = 0; i < fits.fits.size(); ++i) {
    print_line(fmt::format("{:g}", fits.wavelengths_nm[i]), fits.fits[i]);
  }
  fmt::print("{:>16}{:{}} {:>11.3e} {:>11.3e}\n", "all", "", 13 * fits.parameters.size(),
             fits.max_abs_error, fits.rms_error);
}

// What a scene says to use these values.
OrderedJson scene_choice(const std::string& model, const Fits& fits) {
  OrderedJson parameters;
  for (std::size_t p = 0; p < fits.parameters.size(); ++p) {
    OrderedJson& value = parameters[fits.parameters[p].name];
    if (!fits.per_wavelength() || fits.fits.size() == 1) {
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

// The conductors of a scene that are made of the page, or the one that is asked for.
std::vector<std::string> materials_of(const Options& options, const JsonValue& scene) {
  std::vector<std::string> conductors, found;
  const JsonValue materials = scene.member("materials");
  for (const std::string& name : materials.require_object().keys()) {
    const JsonValue material = materials.member(name);
    if (!material.has("type") || material.member("type").json() != "conductor") continue;
    conductors.push_back(name);
    const bool same_page = material.has("nk") && material.member("nk").json() == options.page;
    if (options.material.empty() ? same_page : name == options.material) found.push_back(name);
  }
  if (!found.empty()) return found;
  if (!options.material.empty()) {
    materials.fail(unknown_name_message("conductor", options.material, conductors));
  }
  materials.fail("no conductor has \"nk\": \"" + options.page + "\"; name one with --material");
}

void write_scene(const Options& options, const Fits& fits) {
  const std::string text = read_text_file(options.scene, kMaxSceneBytes);
  const Json checked = parse_json(text, options.scene);
  const std::vector<std::string> names = materials_of(options, JsonValue(checked, options.scene));
  OrderedJson scene = OrderedJson::parse(text);
  for (const std::string& name : names) {
    scene["materials"][name]["fresnel"] = scene_choice(options.model, fits);
  }
  const std::string& path = options.output.empty() ? options.scene : options.output;
  replace_file(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << scene.dump(2) << '\n';
    if (!file.flush()) throw RuntimeError("cannot write \"" + path + "\"");
  });
  fmt::print(stderr, "{}: {} in {}\n", path, options.model, fmt::join(names, ", "));
}

int fit(const Options& options) {
  const FresnelModel& model = *Models::instance().find(options.model);
  const IndexTablePtr table = find_index_table(options.page);
  const Fits fits = fitted(options, model, *table);
  options.as_json ? print_as_json(options, *table, fits) : print_table(options, *table, fits);
  if (!options.scene.empty()) write_scene(options, fits);
  return 0;
}

// "" for a model that has something to fit.
std::string check_model(const std::string& name) {
  const FresnelModel* model = Models::instance().find(name);
  if (!model) return unknown_name_message("Fresnel model", name, Models::instance().names());
  if (!model->parameters().empty()) return "";
  std::vector<std::string> with_parameters;
  for (const std::string& other : Models::instance().names()) {
    if (!Models::instance().find(other)->parameters().empty()) with_parameters.push_back(other);
  }
  return fmt::format("\"{}\" has no free parameters; these have: {}", name,
                     fmt::join(with_parameters, ", "));
}

class FresnelFitCommand final : public Command {
 public:
  void add_to(CLI::App& fresnel, std::function<int()>& action) const override {
    CLI::App* command =
        fresnel.add_subcommand("fit", "Fit a model's free parameters to a material");
    const auto o = std::make_shared<Options>();
    command->add_option("PAGE", o->page, "Index table: id (main/Au/Johnson) or file")->required();
    command->add_option("--model", o->model, "Fresnel model with free parameters")
        ->required()
        ->check(check_model);
    command->add_option("--nm", o->wavelengths, "Wavelengths: FIRST:LAST:STEP, or a list 450,550")
        ->capture_default_str()
        ->check([](const std::string& text) {
          return wavelengths_of(text).empty()
                     ? fmt::format(
                           "found \"{}\", allowed: FIRST:LAST:STEP or a list, in nm, at "
                           "most {} of them",
                           text, kMostWavelengths)
                     : std::string();
        });
    command->add_flag("--over-range", o->over_range,
                      "One set of values for all wavelengths; some models have no other");
    command->add_option("--fix", o->fixed, "NAME=VALUE: a parameter that is not fitted")
        ->check(named_value_check());
    command->add_option("--n-exterior", o->n_exterior, "Index of the medium outside")
        ->capture_default_str()
        ->check(number_check(1e-3, 1e3));
    command->add_flag("--json", o->as_json, "Machine-readable output");
    CLI::Option* scene = command->add_option(
        "--scene", o->scene, "Write the values into the conductors of PAGE in this scene file");
    command->add_option("--material", o->material, "Only into this material")->needs(scene);
    command->add_option("-o,--output", o->output, "Write the scene here, not over --scene")
        ->needs(scene);
    command->footer(
        "Least squares against the exact equations, unweighted over 0 to 89 degrees in steps of "
        "1.\n"
        "Example: karat fresnel fit main/Au/Johnson --model schlick-exponent --nm 400:700:50");
    command->callback([&action, o] { action = [o] { return fit(*o); }; });
  }
};

KARAT_REGISTER(Command, "fresnel fit", FresnelFitCommand);

}  // namespace
}  // namespace karat
