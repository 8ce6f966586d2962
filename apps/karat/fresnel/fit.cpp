// karat fresnel fit: the free parameters of a Fresnel model for one material.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "apps/karat/as_usage.h"
#include "apps/karat/command.h"
#include "apps/karat/fresnel/fit_scene.h"
#include "apps/karat/fresnel/named_values.h"
#include "apps/karat/fresnel/study_options.h"
#include "apps/karat/json_output.h"
#include "apps/karat/number_check.h"
#include "materials/fresnel_study/fresnel_fit_material.h"
#include "materials/index/index_catalogue.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Models = Registry<FresnelModel>;
using OrderedJson = nlohmann::ordered_json;

constexpr double kLeastNm = 1.0, kLargestNm = 1e6;

struct Options {
  std::string page, model, wavelengths = "380:780:5";
  std::vector<std::string> fixed;
  double n_exterior = 1.0;
  bool over_range = false, as_json = false;
  std::string scene, material, output;
};

// "380:780:5", or "450,550,650" in increasing order and once each. Throws InputError.
std::vector<double> wavelengths_of(const std::string& text) {
  if (text.find(':') != std::string::npos) return parse_steps("--nm", text, kLeastNm, kLargestNm);
  std::vector<double> list;
  const char *at = text.data(), *end = at + text.size();
  for (bool more = true; more; ++at) {
    double nm = 0.0;
    const auto [next, error] = std::from_chars(at, end, nm);
    more = next != end;
    if (error != std::errc() || !(nm >= kLeastNm && nm <= kLargestNm) || (more && *next != ',')) {
      throw InputError(fmt::format(
          "--nm: found \"{}\", allowed: FIRST:LAST:STEP or a list as 450,550, from {:g} to {:g} nm",
          text, kLeastNm, kLargestNm));
    }
    list.push_back(nm);
    at = next;
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

OrderedJson fit_json(const FresnelFits& fits, std::size_t i) {
  OrderedJson values;
  for (std::size_t p = 0; p < fits.parameters.size(); ++p) {
    values[fits.parameters[p].name] = fits.fits[i].values[p];
  }
  OrderedJson json;
  if (fits.per_wavelength) json["nm"] = fits.wavelengths_nm[i];
  json["values"] = values;
  json["max_abs_error"] = fits.fits[i].max_abs_error;
  json["rms_error"] = fits.fits[i].rms_error;
  return json;
}

void print_as_json(const Options& options, const IndexTable& table, const FresnelFits& fits) {
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
                         {"fixed", named_values(options.fixed)},
                         {"angles_deg", "0:89:1"},
                         {"wavelengths_nm", fits.wavelengths_nm},
                         {"per_wavelength", fits.per_wavelength},
                         {"fits", list},
                         {"max_abs_error", fits.max_abs_error},
                         {"rms_error", fits.rms_error}});
}

void print_line(const std::string& first, const FresnelFit& fit) {
  fmt::print("{:>16}", first);
  for (const double value : fit.values) fmt::print(" {:>12.6g}", value);
  fmt::print(" {:>11.3e} {:>11.3e}\n", fit.max_abs_error, fit.rms_error);
}

std::string span(const std::vector<double>& wavelengths_nm) {
  const double first = wavelengths_nm.front(), last = wavelengths_nm.back();
  return first == last ? fmt::format("{:g}", first) : fmt::format("{:g} to {:g}", first, last);
}

void print_table(const Options& options, const IndexTable& table, const FresnelFits& fits) {
  fmt::print("{} of {}{} against the exact equations, 0 to 89 degrees in steps of 1\n",
             options.model, table.provenance().name,
             options.n_exterior == 1.0 ? "" : fmt::format(" below n = {:g}", options.n_exterior));
  const std::map<std::string, double> fixed = named_values(options.fixed);
  for (const FresnelParameter& info : fits.parameters) {
    const auto it = fixed.find(info.name);
    fmt::print("  {}: {} ({})\n", info.name, info.description,
               it == fixed.end() ? fmt::format("{:g} to {:g}", info.min, info.max)
                                 : fmt::format("fixed at {:g}", it->second));
  }
  fmt::print("\n{:>16}", "nm");
  for (const FresnelParameter& info : fits.parameters) fmt::print(" {:>12}", info.name);
  fmt::print(" {:>11} {:>11}\n", "max error", "RMS error");
  if (!fits.per_wavelength) return print_line(span(fits.wavelengths_nm), fits.fits[0]);
  for (std::size_t i = 0; i < fits.fits.size(); ++i) {
    print_line(fmt::format("{:g}", fits.wavelengths_nm[i]), fits.fits[i]);
  }
  if (fits.fits.size() == 1) return;
  fmt::print("{:>16}{:{}} {:>11.3e} {:>11.3e}\n", "all", "", 13 * fits.parameters.size(),
             fits.max_abs_error, fits.rms_error);
}

const std::string& output_of(const Options& options) {
  return options.output.empty() ? options.scene : options.output;
}

// What a scene is needed for is checked before the fit is made and printed.
std::optional<FitScene> scene_for(const Options& options, const PlannedFit& plan) {
  if (options.scene.empty()) return std::nullopt;
  std::optional<FitScene> scene(std::in_place, options.scene, options.material, plan);
  check_writable(output_of(options));
  for (const std::string& warning : scene->warnings()) {
    fmt::print(stderr, "karat: warning: {}\n", warning);
  }
  return scene;
}

int fit(const Options& options) {
  const FresnelModel& model = *Models::instance().find(options.model);
  const IndexTablePtr table = find_index_table(full_index_name(options.page));
  const std::vector<double> wavelengths = wavelengths_of(options.wavelengths);
  const MaterialFitOptions how{options.n_exterior, options.over_range, named_values(options.fixed)};
  std::optional<FitScene> scene =
      scene_for(options, {table, wavelengths, options.n_exterior, fits_per_wavelength(model, how),
                          options.over_range});
  const FresnelFits fits = fit_material(model, *table, wavelengths, how);
  options.as_json ? print_as_json(options, *table, fits) : print_table(options, *table, fits);
  if (!scene) return 0;
  scene->write(output_of(options), options.model, fits);
  fmt::print(stderr, "{}: {} in {}: {} for {} nm\n", output_of(options), options.model,
             fmt::join(scene->materials(), ", "),
             fits.per_wavelength ? "values per wavelength" : "one set of values",
             span(fits.wavelengths_nm));
  return 0;
}

bool can_be_fitted(const FresnelModel& model) {
  const std::vector<FresnelParameter> parameters = model.parameters();
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const FresnelParameter& info) { return !info.whole_number; });
}

// "" for a model that has something to fit.
std::string check_model(const std::string& name) {
  const FresnelModel* model = Models::instance().find(name);
  if (!model) return unknown_name_message("Fresnel model", name, Models::instance().names());
  if (can_be_fitted(*model)) return "";
  std::vector<std::string> with_parameters;
  for (const std::string& other : Models::instance().names()) {
    if (can_be_fitted(*Models::instance().find(other))) with_parameters.push_back(other);
  }
  return fmt::format("\"{}\" has no parameters to fit; these have: {}", name,
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
        ->capture_default_str();
    command->add_flag("--over-range", o->over_range,
                      "One set of values for all wavelengths; some models have no other");
    command->add_option("--fix", o->fixed, "NAME=VALUE: a parameter that is not fitted")
        ->allow_extra_args(false)
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
    command->callback([&action, o] {
      as_usage([&] { wavelengths_of(o->wavelengths); });
      action = [o] { return fit(*o); };
    });
  }
};

KARAT_REGISTER(Command, "fresnel fit", FresnelFitCommand);

}  // namespace
}  // namespace karat
