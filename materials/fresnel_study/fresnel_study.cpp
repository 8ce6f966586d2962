#include "materials/fresnel_study/fresnel_study.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "materials/fresnel_study/fresnel_on_grid.h"
#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

std::vector<double> steps(double first, double last, double step) {
  std::vector<double> values;
  const int count = static_cast<int>(std::lround((last - first) / step)) + 1;
  for (int i = 0; i < count; ++i) values.push_back(first + i * step);
  return values;
}

// "main/Au/Johnson" to "main/Au/"; nothing for what is no catalogue id.
std::string book_of(const std::string& name) {
  if (std::count(name.begin(), name.end(), '/') != 2) return "";
  return name.substr(0, name.rfind('/') + 1);
}

FresnelModelStudy study_model(const std::string& name, const FresnelMaterialStudy& material,
                              const FresnelStudyOptions& options) {
  FresnelModelStudy study;
  study.model = name;
  study.curves = fresnel_curves(fresnel_model(name), *material.table, options.grid);
  study.error = fresnel_errors(study.curves.unpolarised, material.exact.unpolarised, options.grid);
  study.colours = fresnel_colours(study.curves, options.grid, options.viewing);
  study.colour_error =
      fresnel_colour_errors(study.colours, material.colours, options.grid, options.viewing);
  for (std::size_t i = 0; i < study.curves.albedo.size(); ++i) {
    study.albedo_max_abs_error = std::max(
        study.albedo_max_abs_error, std::abs(study.curves.albedo[i] - material.exact.albedo[i]));
  }
  return study;
}

// Tables that do not cover the grid, or that no physical index can be read from, are left out.
std::vector<FresnelTableStudy> study_other_tables(const FresnelMaterialStudy& material,
                                                  const FresnelStudyOptions& options) {
  std::vector<FresnelTableStudy> studies;
  const std::string own = material.table->provenance().name, book = book_of(own);
  if (book.empty()) return studies;
  for (const IndexTableEntry& entry : list_index_tables()) {
    if (!entry.name.starts_with(book) || entry.name == own) continue;
    try {
      const IndexTablePtr table = find_index_table(entry.name);
      const FresnelCurves curves = exact_fresnel_curves(*table, options.grid);
      const FresnelColours colours = fresnel_colours(curves, options.grid, options.viewing);
      studies.push_back(
          {entry.name, fresnel_errors(curves.unpolarised, material.exact.unpolarised, options.grid),
           fresnel_colour_errors(colours, material.colours, options.grid, options.viewing)});
    } catch (const InputError&) {
    }
  }
  return studies;
}

}  // namespace

FresnelGrid usual_fresnel_grid() { return {steps(380.0, 780.0, 5.0), steps(0.0, 89.0, 1.0)}; }

FresnelErrors fresnel_errors(const GridValues& model, const GridValues& exact,
                             const FresnelGrid& grid) {
  FresnelErrors errors;
  double absolute = 0.0, square = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double error = model[i] - exact[i];
    absolute += std::abs(error), square += error * error, sum += error;
    if (i > 0 && !(std::abs(error) > errors.max_abs)) continue;
    errors.max_abs = std::abs(error);
    errors.worst_deg = grid.angles_deg[i / grid.wavelengths_nm.size()];
    errors.worst_nm = grid.wavelengths_nm[i % grid.wavelengths_nm.size()];
  }
  const double count = static_cast<double>(exact.size());
  errors.mean_abs = absolute / count;
  errors.rms = std::sqrt(square / count);
  errors.mean_signed = sum / count;
  return errors;
}

std::vector<FresnelMaterialStudy> study_fresnel_models(
    const FresnelStudyOptions& options,
    const std::function<void(std::size_t, std::size_t)>& after_each) {
  std::vector<FresnelMaterialStudy> studies;
  for (const std::string& name : options.models) fresnel_model(name);
  for (const std::string& name : options.tables) {
    FresnelMaterialStudy& study = studies.emplace_back();
    study.table = find_index_table(name);
    study.exact = exact_fresnel_curves(*study.table, options.grid);
    study.colours = fresnel_colours(study.exact, options.grid, options.viewing);
    study.models.resize(options.models.size());
  }
  const std::size_t models = options.models.size(), total = studies.size() * models;
  std::size_t done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, total, [&](std::size_t i) {
    FresnelMaterialStudy& material = studies[i / models];
    material.models[i % models] = study_model(options.models[i % models], material, options);
    const std::lock_guard lock(mutex);
    if (after_each) after_each(++done, total);
  });
  tbb::parallel_for(std::size_t{0}, studies.size(), [&](std::size_t i) {
    studies[i].other_tables = study_other_tables(studies[i], options);
  });
  return studies;
}

}  // namespace karat
