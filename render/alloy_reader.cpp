#include "render/alloy_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "materials/index/element.h"
#include "materials/index/index_mixture.h"
#include "render/alloy_presets.h"
#include "render/index_reader.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kSumTolerance = 1e-6;
constexpr int kMostNestedPresets = 16;
constexpr std::size_t kMostParts = 64, kMostPresetBytes = std::size_t{1} << 20;

struct Part {
  NamedIndex index;
  double fraction = 0.0;             // in the unit of "by"
  double volume_per_fraction = 1.0;  // up to a common factor
};

// A number of the part's own, or that of the element whose table it is.
double property(const JsonValue& part, const std::string& key, const Allowed& allowed,
                const NamedIndex& index, double Element::*of_element) {
  if (part.has(key)) return part.member(key).number(allowed);
  const std::optional<Element> element = element_of_table(index.name);
  if (!element) {
    part.fail(fmt::format("the {} of \"{}\" is not known: say {{\"fraction\": ..., \"{}\": ...}}",
                          key == "density" ? "density (g/cm3)" : "molar mass (g/mol)", index.name,
                          key));
  }
  return (*element).*of_element;
}

double volume_per_fraction(const JsonValue& part, const NamedIndex& index, const std::string& by) {
  if (by == "volume") return 1.0;
  const double density =
      property(part, "density", {kLeastDensity, kMostDensity}, index, &Element::density_g_cm3);
  if (by == "mass") return 1.0 / density;
  return property(part, "molar_mass", {1e-6, 1e6}, index, &Element::atomic_mass) / density;
}

// `value` is what stands beside the name, or the element of the list.
Part read_part(const JsonValue& value, NamedIndex index, const std::string& by) {
  const Allowed allowed{0.0, 1.0};
  const bool bare = value.json().is_number();
  Part part;
  part.fraction = (bare ? value : value.member("fraction")).number(allowed);
  part.volume_per_fraction = volume_per_fraction(value, index, by);
  part.index = std::move(index);
  return part;
}

std::vector<Part> read_parts(const JsonValue& parts, const std::string& by,
                             const ReadContext& context) {
  if (parts.size() == 0) parts.fail("an alloy needs at least one part");
  if (parts.size() > kMostParts) parts.fail(fmt::format("more than {} parts", kMostParts));
  std::vector<Part> found;
  for (const IndexMember& member : index_members(parts, "fraction", {"density", "molar_mass"})) {
    found.push_back(read_part(member.value, read_member(member, context), by));
  }
  double sum = 0.0;
  for (const Part& part : found) sum += part.fraction;
  if (!(std::abs(sum - 1.0) <= kSumTolerance)) {
    parts.fail(fmt::format("the fractions sum to {:.7g}, allowed: 1", sum));
  }
  return found;
}

std::size_t host_of(const JsonValue& value, const std::vector<Part>& parts,
                    const std::vector<MixturePart>& mixture, const MixingRule& rule) {
  if (value.has("host")) {
    if (!rule.has_host()) value.member("host").fail("this model has no host");
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(part.index.name);
    const std::string& name = value.member("host").choice("host", names);
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  const auto less = [](const MixturePart& a, const MixturePart& b) {
    return a.volume_fraction < b.volume_fraction;
  };
  return static_cast<std::size_t>(std::max_element(mixture.begin(), mixture.end(), less) -
                                  mixture.begin());
}

Provenance provenance_of(const std::vector<Part>& parts, const std::vector<MixturePart>& mixture,
                         const std::string& by, const std::string& model) {
  std::string name, volumes;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    name += fmt::format("{}{:.6g} {}", i > 0 ? " + " : "", parts[i].fraction, parts[i].index.name);
    volumes += fmt::format("{}{:.4f}", i > 0 ? ", " : "", mixture[i].volume_fraction);
  }
  Provenance provenance;
  provenance.name = fmt::format("alloy by {} ({}): {}", by, model, name);
  provenance.reference = Registry<MixingRule>::instance().find(model)->source();
  if (by != "volume") {
    provenance.reference += fmt::format("; parts by volume {}, from densities where not given: {}",
                                        volumes, elements_source());
  }
  return provenance;
}

IndexTablePtr read_mixture(const JsonValue& value, const ReadContext& context) {
  value.allow_keys({"alloy", "by", "model", "host"});
  const auto& rules = Registry<MixingRule>::instance();
  const std::string by = value.member("by").choice("kind of fraction", {"mass", "volume", "atom"});
  const std::string model = value.has("model")
                                ? value.member("model").choice("mixing model", rules.names())
                                : "bruggeman";
  const std::vector<Part> parts = read_parts(value.member("alloy"), by, context);
  std::vector<MixturePart> mixture;
  double volume = 0.0;
  for (const Part& part : parts) volume += part.fraction * part.volume_per_fraction;
  for (const Part& part : parts) {
    mixture.push_back({part.index.table, part.fraction * part.volume_per_fraction / volume});
  }
  const MixingRule& rule = *rules.find(model);
  const std::size_t host = host_of(value, parts, mixture, rule);
  Provenance provenance = provenance_of(parts, mixture, by, model);
  try {
    return mixed_index(std::move(mixture), rule, host, std::move(provenance));
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

// The preset's file holds "description", "source" and "nk", an index like any other.
IndexTablePtr read_preset(const JsonValue& name, const ReadContext& context) {
  std::string path;
  try {
    path = alloy_file(name.string());
  } catch (const InputError& error) {
    name.fail(error.what());
  }
  remember_file(path, context);
  const Json preset = parse_json(read_text_file(path, kMostPresetBytes), path);
  const JsonValue document(preset, path);
  document.allow_keys({"description", "source", "nk"});
  Provenance provenance;
  provenance.name = "alloy " + name.string() + ": " + document.member("description").string();
  provenance.file = path;
  provenance.reference = document.member("source").string();
  collect(provenance, context);
  ReadContext inside = context;
  inside.directory = std::filesystem::path(path).parent_path().string();
  if (++inside.preset_depth > kMostNestedPresets) {
    name.fail(fmt::format("presets of alloys nested deeper than {}", kMostNestedPresets));
  }
  return read_index(document.member("nk"), inside);
}

}  // namespace

IndexTablePtr read_alloy(const JsonValue& value, const ReadContext& context) {
  const JsonValue alloy = value.member("alloy");
  if (alloy.json().is_string()) {
    value.allow_keys({"alloy"});
    return read_preset(alloy, context);
  }
  if (!alloy.json().is_object() && !alloy.json().is_array()) {
    alloy.fail_found(
        "the name of an alloy, {NAME: fraction, ...} or [{\"nk\", \"fraction\"}, ...]");
  }
  return read_mixture(value, context);
}

}  // namespace karat
