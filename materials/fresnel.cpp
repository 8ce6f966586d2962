#include "materials/fresnel.h"

#include <fmt/format.h>

#include <cmath>

#include "spectral/support/error.h"

namespace karat {

const FresnelModel& fresnel_model(const std::string& name) {
  const auto& models = Registry<FresnelModel>::instance();
  if (const FresnelModel* model = models.find(name)) return *model;
  throw InputError(unknown_name_message("Fresnel model", name, models.names()));
}

std::string parameter_error(const FresnelParameter& parameter, double value) {
  const bool in_range = value >= parameter.min && value <= parameter.max;  // false for a NaN
  if (in_range && (!parameter.whole_number || value == std::floor(value))) return "";
  return fmt::format("found {:g}, allowed: {:g} to {:g}{}", value, parameter.min, parameter.max,
                     parameter.whole_number ? ", a whole number" : "");
}

}  // namespace karat
