// karat fresnel study: what approximations cost, in error and in time.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <tuple>

#include "apps/karat/as_usage.h"
#include "apps/karat/command.h"
#include "apps/karat/fresnel/study_options.h"
#include "apps/karat/fresnel/study_report.h"
#include "apps/karat/json_output.h"
#include "apps/karat/number_check.h"
#include "apps/karat/progress.h"
#include "materials/index/index_catalogue.h"
#include "render/replace_file.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

struct Options {
  std::vector<std::string> tables = usual_study_tables();
  std::vector<std::string> models;  // empty: all
  std::string illuminant = "D65", observer = "cie1931";
  std::string nm = "380:780:5", angles = "0:89:1";
  std::string folder = "fresnel-study";
  std::string progress;
  bool as_json = false;
  bool no_render = false;
  std::string render_size = "432x243";
  int spp = 64, threads = 0;

  // That makes this report again, with what is not default.
  std::string command() const {
    const Options usual;
    std::string text = "karat fresnel study";
    const auto add = [&](bool differs, const char* option, const std::string& value) {
      if (differs) text += fmt::format(" {} {}", option, value);
    };
    add(tables != usual.tables, "--nk", fmt::format("{}", fmt::join(tables, ",")));
    add(!models.empty(), "--models", fmt::format("{}", fmt::join(models, ",")));
    add(illuminant != usual.illuminant, "--illuminant", illuminant);
    add(observer != usual.observer, "--observer", observer);
    add(nm != usual.nm, "--nm", nm);
    add(angles != usual.angles, "--angles", angles);
    if (no_render) return text + " --no-render";
    add(render_size != usual.render_size, "--render-size", render_size);
    add(spp != usual.spp, "--spp", std::to_string(spp));
    return text;
  }
};

void require_distinct(const std::string& option, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) throw InputError("", option, "\"" + *twice + "\" is named twice");
}

// Of a list's part, without blanks around it: empty, or why it is no model's name.
std::string model_error(std::string& name) {
  name = CLI::detail::trim_copy(name);
  const auto& models = Registry<FresnelModel>::instance();
  return models.find(name) ? "" : unknown_name_message("Fresnel model", name, models.names());
}

// What can be told wrong before any table is read is wrong usage.
void check_usage(const Options& options) {
  as_usage([&] {
    parse_steps("--nm", options.nm, 1.0, 1e6);
    parse_steps("--angles", options.angles, 0.0, 90.0);
    parse_size(options.render_size);
    require_distinct("--models", options.models);
  });
  if (options.folder.empty()) throw CLI::ValidationError("--output: needs the name of a folder");
}

FresnelStudyOptions study_options(const Options& options) {
  FresnelStudyOptions study;
  for (const std::string& typed : options.tables) {
    study.tables.push_back(full_index_name(typed));
  }
  require_distinct("--nk", study.tables);
  study.models = options.models.empty() ? usual_study_models() : options.models;
  study.grid = {parse_steps("--nm", options.nm, 1.0, 1e6),
                parse_steps("--angles", options.angles, 0.0, 90.0)};
  study.viewing = {options.illuminant, options.observer};
  return study;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RuntimeError(folder + ": cannot be created: " + error.message());
  check_writable(folder + "/study.json");
}

void write_json(const std::string& path, const nlohmann::ordered_json& json) {
  replace_file(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    if (!file.flush()) throw RuntimeError(path + ": cannot be written");
  });
}

// Costs are measured on the first material: they do not depend on it.
void measure(StudyReport& report, Progress& progress) {
  const std::vector<std::string>& models = report.options.models;
  const IndexTable& table = *report.materials.front().table;
  FresnelCostOptions options;
  options.after_round = [&](int done, int total) {
    progress.stage("cost of 16 wavelengths", static_cast<double>(done) / total);
  };
  report.costs = fresnel_costs(models, table, options);
  report.call_ns = report.costs.back().ns.median;
  report.costs.pop_back();
  options.after_round = [&](int done, int total) {
    progress.stage("cost of one wavelength", static_cast<double>(done) / total);
  };
  report.single_costs = fresnel_single_costs(models, table, options);
}

FresnelRenders render_rings(const Options& options, const std::vector<std::string>& models,
                            Progress& progress) {
  FresnelRenderOptions render;
  render.scene = data_path("scenes/fresnel_rings.json");
  render.models = models;
  std::tie(render.width, render.height) = parse_size(options.render_size);
  render.spp = options.spp;
  render.threads = options.threads;
  render.progress = [&](double done) { progress.stage("renders", done); };
  return render_fresnel_models(render);
}

// Of an earlier study in the same folder: what this one may not write again, and what would then
// stand beside it as if it belonged to it. Only names that a study gives.
void remove_earlier(const std::string& folder) {
  namespace fs = std::filesystem;
  if (!fs::exists(folder + "/study.json")) return;
  static const std::regex ours(
      "(reflectance|albedo)-.*\\.csv|render\\.csv|(reflectance|error-maps|colour)-.*\\.svg");
  std::error_code ignored;
  for (const char* part : {"/csv", "/figures"}) {
    for (const auto& entry : fs::directory_iterator(folder + part, ignored)) {
      if (std::regex_match(entry.path().filename().string(), ours)) fs::remove(entry, ignored);
    }
  }
  for (const std::string& model : Registry<FresnelModel>::instance().names()) {
    fs::remove(folder + "/pictures/" + model + ".png", ignored);
    fs::remove(folder + "/pictures/" + model + "-difference.png", ignored);
  }
}

nlohmann::ordered_json write_report(const std::string& folder, const StudyReport& report) {
  const nlohmann::ordered_json json = study_json(report);
  remove_earlier(folder);
  write_json(folder + "/study.json", json);
  write_study_csv(folder, report);
  write_study_figures(folder, report);
  if (report.renders) write_study_pictures(folder, *report.renders);
  write_study_html(folder, report);
  return json;
}

int run(const Options& options) {
  StudyReport report;
  report.options = study_options(options);
  report.command = options.command();
  make_folder(options.folder);
  Progress progress(options.progress, 0.0);

  report.materials = study_fresnel_models(report.options, [&](std::size_t done, std::size_t total) {
    progress.stage("errors and colours", static_cast<double>(done) / static_cast<double>(total));
  });
  measure(report, progress);
  report.ranking = rank_fresnel_models(report.materials, report.costs);
  if (!options.no_render) {
    report.renders = render_rings(options, report.options.models, progress);
  }
  report.summary = study_summary(report);
  progress.stage("writing", 0.0);
  const nlohmann::ordered_json json = write_report(options.folder, report);
  progress.stage("writing", 1.0);
  progress.finish();
  if (options.as_json) print_json(json);
  progress.note("report: " + options.folder + "/index.html");
  return 0;
}

class FresnelStudyCommand final : public Command {
 public:
  void add_to(CLI::App& fresnel, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* study = fresnel.add_subcommand(
        "study", "Error, colour and cost of Fresnel models: a report in a folder");
    study->add_option("--nk", options->tables, "Index tables (twelve metals)")->delimiter(',');
    study->add_option("--models", options->models, "Fresnel models (all)")
        ->delimiter(',')
        ->transform(CLI::Validator(model_error, ""));
    study->add_option("--illuminant", options->illuminant, "Light under which colours are compared")
        ->capture_default_str();
    study->add_option("--observer", options->observer, "Standard observer that compares them")
        ->capture_default_str();
    study->add_option("--nm", options->nm, "Wavelengths of the error statistics, FIRST:LAST:STEP")
        ->capture_default_str();
    study->add_option("--angles", options->angles, "Angles of the same, in degrees")
        ->capture_default_str();
    study->add_option("-o,--output", options->folder, "Folder for the report")
        ->capture_default_str();
    study->add_flag("--no-render", options->no_render, "Leave the rendered rings out");
    study->add_option("--render-size", options->render_size, "Size of the rendered pictures")
        ->capture_default_str();
    study->add_option("--spp", options->spp, "Samples per pixel of each picture")
        ->capture_default_str()
        ->check(number_check(1, 65536));
    study->add_option("--threads", options->threads, "Threads that render (all)")
        ->check(number_check(0, 4096));
    study->add_option("--progress", options->progress, "bar, lines, json or none")
        ->check(CLI::IsMember({"bar", "lines", "json", "none"}));
    study->add_flag("--json", options->as_json, "Print study.json too");
    study->footer("Example: karat fresnel study --nk main/Au/Johnson,main/Cu/Johnson -o study");
    study->callback([&action, options] {
      check_usage(*options);
      action = [options] { return run(*options); };
    });
  }
};

KARAT_REGISTER(Command, "fresnel study", FresnelStudyCommand);

}  // namespace
}  // namespace karat
