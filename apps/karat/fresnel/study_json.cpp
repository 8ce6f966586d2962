// study.json: the summary of a study for programs.
#include <algorithm>
#include <stdexcept>

#include "apps/karat/fresnel/study_report.h"
#include "render/version.h"

namespace karat {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const CostSpread& spread) {
  return {{"median", spread.median}, {"lower", spread.lower}, {"upper", spread.upper}};
}

Json machine_json() {
  return {{"processor", processor_name()},
          {"compiler", compiler()},
          {"flags", compiler_flags()},
          {"vector_instructions", vector_instructions()}};
}

Json material_json(const FresnelMaterialStudy& material) {
  const Provenance& source = material.table->provenance();
  const WavelengthRange range = material.table->range();
  Json tables = Json::array();
  for (const FresnelTableStudy& other : material.other_tables) {
    tables.push_back({{"table", other.table},
                      {"max_abs_difference", other.error.max_abs},
                      {"mean_abs_difference", other.error.mean_abs},
                      {"rms_difference", other.error.rms},
                      {"delta_e_mean", other.colour_error.mean},
                      {"delta_e_max", other.colour_error.max},
                      {"delta_e_albedo", other.colour_error.albedo}});
  }
  return {{"table", source.name},
          {"name", short_name(material)},
          {"reference", source.reference},
          {"range_nm", {range.min_nm, range.max_nm}},
          {"normal_linear_srgb", linear_srgb_of_xyz(material.colours.per_angle.front())},
          {"albedo_linear_srgb", linear_srgb_of_xyz(material.colours.albedo)},
          {"other_tables", tables}};
}

// Relative to exact beyond what an empty call takes, which a renderer pays for every model.
double net_cost(const StudyReport& report, const FresnelCost& cost) {
  const double exact = cost_of(report.costs, "exact").ns.median - report.call_ns;
  return std::max(cost.ns.median - report.call_ns, 0.0) / exact;
}

Json model_json(const StudyReport& report, const std::string& name) {
  const FresnelModel& model = *Registry<FresnelModel>::instance().find(name);
  const FresnelCost& cost = cost_of(report.costs, name);
  const FresnelCost& single = cost_of(report.single_costs, name);
  return {{"model", name},
          {"description", model.description()},
          {"source", model.source()},
          {"ns_per_call", spread_json(cost.ns)},
          {"ns_per_wavelength", cost.ns.median / kLanes},
          {"cost_relative", spread_json(cost.relative)},
          {"cost_relative_net", net_cost(report, cost)},
          {"ns_single", spread_json(single.ns)},
          {"cost_relative_single", spread_json(single.relative)}};
}

Json result_json(const StudyReport& report, const FresnelMaterialStudy& material,
                 const FresnelModelStudy& study) {
  return {{"material", material.table->provenance().name},
          {"model", study.model},
          {"max_abs_error", study.error.max_abs},
          {"mean_abs_error", study.error.mean_abs},
          {"rms_error", study.error.rms},
          {"mean_signed_error", study.error.mean_signed},
          {"max_abs_error_nm", study.error.worst_nm},
          {"max_abs_error_deg", study.error.worst_deg},
          {"delta_e_mean", study.colour_error.mean},
          {"delta_e_max", study.colour_error.max},
          {"delta_e_max_deg", study.colour_error.worst_deg},
          {"delta_e_albedo", study.colour_error.albedo},
          {"albedo_max_abs_error", study.albedo_max_abs_error},
          {"cost_relative", cost_of(report.costs, study.model).relative.median}};
}

Json renders_json(const FresnelRenders& renders) {
  Json json = {{"width", renders.width},
               {"height", renders.height},
               {"spp", renders.spp},
               {"delta_e_scale", kPictureScale},
               {"noise_delta_e_mean", renders.noise.mean},
               {"noise_delta_e_p95", renders.noise.p95},
               {"noise_relative_time", spread_json(renders.noise_time)},
               {"fresnel_share", spread_json(renders.fresnel_share)},
               {"evaluations_per_sample", renders.evaluations_per_sample},
               {"models", Json::array()}};
  for (const FresnelRender& render : renders.models) {
    json["models"].push_back({{"model", render.model},
                              {"delta_e_mean", render.difference.mean},
                              {"delta_e_p95", render.difference.p95},
                              {"delta_e_max", render.difference.max},
                              {"relative_time", spread_json(render.relative_time)},
                              {"cpu_seconds", render.cpu_seconds}});
  }
  return json;
}

Json rank_json(const FresnelRank& rank) {
  return {{"model", rank.model},
          {"cost_relative", rank.cost_relative},
          {"max_abs_error", rank.max_abs_error},
          {"rms_error", rank.rms_error},
          {"delta_e_mean", rank.delta_e_mean},
          {"delta_e_max", rank.delta_e_max},
          {"delta_e_max_material", rank.worst_material},
          {"delta_e_albedo", rank.delta_e_albedo},
          {"efficient", rank.efficient}};
}

}  // namespace

const FresnelCost& cost_of(const std::vector<FresnelCost>& costs, const std::string& model) {
  const auto cost = std::find_if(costs.begin(), costs.end(),
                                 [&](const FresnelCost& c) { return c.model == model; });
  if (cost == costs.end()) throw std::logic_error("no cost of model " + model);
  return *cost;
}

std::string short_name(const FresnelMaterialStudy& material) {
  std::string name = material.table->provenance().name;
  const std::size_t shelf = name.find('/');
  if (std::count(name.begin(), name.end(), '/') == 2) name.erase(0, shelf + 1);
  std::replace(name.begin(), name.end(), '/', ' ');
  return name;
}

std::string file_name(const FresnelMaterialStudy& material) {
  std::string name = short_name(material);
  for (char& c : name) {
    const bool plain =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.';
    if (!plain) c = '-';
  }
  return name;
}

Json study_json(const StudyReport& report) {
  Json json = {
      {"karat", version()},
      {"commit", commit()},
      {"command", report.command},
      {"grid",
       {{"wavelengths_nm", report.options.grid.wavelengths_nm},
        {"angles_deg", report.options.grid.angles_deg},
        {"weighting", "none"}}},
      {"illuminant", report.options.viewing.illuminant},
      {"observer", report.options.viewing.observer},
      {"machine", machine_json()},
      {"wavelengths_per_call", int{kLanes}},
      {"call_overhead_ns", report.call_ns},
      {"published_2005",
       {{"schlick", 0.28}, {"lazanyi", 0.33}, {"lazanyi-compensated", 0.54}, {"exact", 1.0}}},
      {"summary", report.summary},
      {"models", Json::array()},
      {"materials", Json::array()},
      {"results", Json::array()},
      {"ranking", Json::array()}};
  for (const auto& name : report.options.models) json["models"].push_back(model_json(report, name));
  for (const auto& material : report.materials) {
    json["materials"].push_back(material_json(material));
    for (const auto& study : material.models) {
      json["results"].push_back(result_json(report, material, study));
    }
  }
  if (report.renders) json["render"] = renders_json(*report.renders);
  for (const auto& rank : report.ranking) json["ranking"].push_back(rank_json(rank));
  return json;
}

}  // namespace karat
