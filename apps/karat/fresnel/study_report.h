// What `karat fresnel study` found, and the forms in which it is written.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "materials/fresnel_cost.h"
#include "materials/fresnel_ranking.h"
#include "materials/fresnel_study.h"

namespace karat {

struct StudyReport {
  FresnelStudyOptions options;
  std::string command;  // that made it
  std::vector<FresnelMaterialStudy> materials;
  std::vector<FresnelCost> costs;  // of kLanes wavelengths, in the order of the models
  double call_ns = 0.0;            // of a model that does nothing, contained in `costs`
  std::vector<FresnelRank> ranking;
  std::vector<std::string> summary;  // sentences
};

// The cost of a model of the study.
const FresnelCost& cost_of(const StudyReport& report, const std::string& model);

// The last part of a table's name that tells it apart in this study: "Au Johnson".
std::string short_name(const FresnelMaterialStudy& material);

// Everything but the values over the grid; docs/fresnel.md documents the keys.
nlohmann::ordered_json study_json(const StudyReport& report);

// Sentences for people, computed from the numbers.
std::vector<std::string> study_summary(const StudyReport& report);

// csv/*.csv below `folder`: every number. Throws RuntimeError.
void write_study_csv(const std::string& folder, const StudyReport& report);

// One page that needs nothing else. Throws RuntimeError.
void write_study_html(const std::string& file, const StudyReport& report);

}  // namespace karat
