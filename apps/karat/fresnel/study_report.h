// What `karat fresnel study` found, and the forms in which it is written.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "materials/fresnel_study/fresnel_cost.h"
#include "materials/fresnel_study/fresnel_ranking.h"
#include "materials/fresnel_study/fresnel_study.h"
#include "render/fresnel_renders.h"

namespace karat {

struct StudyReport {
  FresnelStudyOptions options;
  std::string command;  // that made it
  std::vector<FresnelMaterialStudy> materials;
  std::vector<FresnelCost> costs;         // of kLanes wavelengths, in the order of the models
  double call_ns = 0.0;                   // of a model that does nothing, contained in `costs`
  std::vector<FresnelCost> single_costs;  // of one wavelength, straight from n and k
  std::optional<FresnelRenders> renders;
  std::vector<FresnelRank> ranking;
  std::vector<std::string> summary;  // sentences
};

// The cost of a model among `costs`.
const FresnelCost& cost_of(const std::vector<FresnelCost>& costs, const std::string& model);

// "Au Johnson", and the same for names of files: "Au-Johnson".
std::string short_name(const FresnelMaterialStudy& material);
std::string file_name(const FresnelMaterialStudy& material);

// Everything but the values over the grid; docs/fresnel.md documents the keys.
nlohmann::ordered_json study_json(const StudyReport& report);

// Sentences for people, computed from the numbers.
std::vector<std::string> study_summary(const StudyReport& report);

// The end of the scale of difference pictures: CIEDE2000.
inline constexpr double kPictureScale = 6.0;

// PNG files of a render and of its difference from exact below `folder`/pictures, and the scale's
// colours. Throws RuntimeError.
void write_study_pictures(const std::string& folder, const FresnelRenders& renders);

// figures/*.svg below `folder`. Throws RuntimeError.
void write_study_figures(const std::string& folder, const StudyReport& report);

// csv/*.csv below `folder`: every number. Throws RuntimeError.
void write_study_csv(const std::string& folder, const StudyReport& report);

// index.html in `folder`: one page that needs nothing else; the pictures are there already. Throws
// RuntimeError.
void write_study_html(const std::string& folder, const StudyReport& report);

}  // namespace karat
