#include "materials/roughness.h"

#include <algorithm>

#include "spectral/support/error.h"

namespace karat {
namespace {

ParameterInfo width(std::string name, std::string description) {
  ParameterInfo info;
  info.name = std::move(name);
  info.description = std::move(description);
  info.min = 0.0;
  info.max = 1.0;
  return info;
}

Vec2 read_alpha(const Parameters& p) {
  const bool along = p.has("alpha_x"), across = p.has("alpha_y");
  if (p.has("roughness") && (p.has("alpha") || along || across)) {
    throw InputError(
        "\"roughness\" and \"alpha\" name the same thing (alpha = roughness^2): give one");
  }
  if (p.has("alpha") && (along || across)) {
    throw InputError("\"alpha\" is for both axes: give it, or \"alpha_x\" and \"alpha_y\"");
  }
  if (along != across) {
    throw InputError(std::string("\"") + (along ? "alpha_x" : "alpha_y") +
                     "\" is given without \"" + (along ? "alpha_y" : "alpha_x") + "\"");
  }
  if (along) {
    return {static_cast<float>(p.number("alpha_x")), static_cast<float>(p.number("alpha_y"))};
  }
  double alpha = 0.0;
  if (p.has("alpha")) alpha = p.number("alpha");
  if (p.has("roughness")) alpha = p.number("roughness") * p.number("roughness");
  return {static_cast<float>(alpha), static_cast<float>(alpha)};
}

}  // namespace

std::vector<ParameterInfo> roughness_parameters() {
  ParameterInfo distribution;
  distribution.name = "distribution";
  distribution.type = ParameterType::kChoice;
  distribution.description = "distribution of microfacet normals";
  distribution.default_json = "\"ggx\"";
  distribution.choices = Registry<MicrofacetDistribution>::instance().names();
  return {
      distribution,
      width("alpha",
            "width of the distribution, as it stands in its formula: 0, the default, is a mirror, "
            "0.1 satin, 0.3 matt; below 0.001 the surface is smooth"),
      width("alpha_x", "width along the tangent, instead of alpha and together with alpha_y"),
      width("alpha_y", "width across the tangent, instead of alpha and together with alpha_x"),
      width("roughness", "perceptual roughness instead of alpha: alpha = roughness^2")};
}

Roughness read_roughness(const Parameters& parameters, std::vector<std::string>& warnings) {
  const auto& distributions = Registry<MicrofacetDistribution>::instance();
  const std::string& name = parameters.string("distribution");
  const MicrofacetDistribution* distribution = distributions.find(name);
  if (!distribution) {
    throw InputError(unknown_name_message("distribution", name, distributions.names()));
  }
  const Vec2 alpha = read_alpha(parameters);
  const float smaller = std::min(alpha.x, alpha.y);
  if (smaller >= kSmoothBelowAlpha) return {distribution, alpha};
  if (std::max(alpha.x, alpha.y) > 0.0f) {
    warnings.push_back("alpha " + std::to_string(smaller) +
                       " is below 0.001: the surface is rendered as smooth");
  }
  return {distribution, {0.0f, 0.0f}};
}

}  // namespace karat
