#include "render/spectrum_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "materials/index/index_coverage.h"
#include "render/index_reader.h"
#include "render/named_index.h"
#include "render/scene_path.h"
#include "render/spectrum_columns.h"
#include "spectral/colour.h"
#include "spectral/illuminant.h"
#include "spectral/rgb_to_spectrum.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMaxSpectrumBytes = std::size_t{16} << 20;
constexpr double kLargestValue = 1e30;

SpectrumPtr read_table(const JsonValue& value, const Allowed& allowed) {
  value.require_array();
  std::vector<SpectrumSample> rows;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue row = value.element(i);
    if (!row.json().is_array() || row.size() != 2) row.fail_found("[wavelength in nm, value]");
    rows.push_back({row.element(0).number({0.0, 1e9, true}), row.element(1).number(allowed)});
  }
  try {
    return spectrum_of_rows(rows, "table " + value.place());
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

SpectrumPtr read_spectrum_file(const JsonValue& value, const Allowed& allowed,
                               const ReadContext& context) {
  const std::string path = read_path(value, context);
  try {
    return spectrum_of_text(read_text_file(path, kMaxSpectrumBytes), path, allowed);
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

Rgb read_rgb(const JsonValue& object, double largest) {
  const auto rgb = object.member("rgb").numbers(3, {0.0, largest});
  return {rgb[0], rgb[1], rgb[2]};
}

// Exactly one of `kinds` names what the spectrum is.
std::string kind_of(const JsonValue& object, const std::vector<std::string>& kinds) {
  std::string found;
  for (const auto& kind : kinds) {
    if (!object.has(kind)) continue;
    if (!found.empty()) object.fail("\"" + found + "\" and \"" + kind + "\" exclude each other");
    found = kind;
  }
  if (found.empty()) {
    object.fail_found(
        fmt::format("a number, or an object with one of: {}", fmt::join(kinds, ", ")));
  }
  return found;
}

SpectrumPtr named_illuminant(const JsonValue& value) {
  return normalised(illuminant(value.choice("illuminant", illuminant_names())));
}

SpectrumPtr emission_before_scale(const JsonValue& object, const ReadContext& context) {
  if (object.has("rgb")) {
    object.allow_keys({"rgb", "illuminant", "scale", "luminance"});
    const SpectrumPtr lamp = object.has("illuminant")
                                 ? named_illuminant(object.member("illuminant"))
                                 : illuminant("D65");
    return rgb_illuminant_spectrum(read_rgb(object, 1e12), lamp);
  }
  object.allow_keys({"rgb", "illuminant", "blackbody", "table", "file", "scale", "luminance"});
  const std::string kind = kind_of(object, {"rgb", "illuminant", "blackbody", "table", "file"});
  const JsonValue value = object.member(kind);
  const Allowed allowed{0.0, kLargestValue};
  if (kind == "illuminant") return named_illuminant(value);
  if (kind == "blackbody") return blackbody_spectrum(value.number({100.0, 1e6}));
  if (kind == "table") return read_table(value, allowed);
  return read_spectrum_file(value, allowed, context);
}

SpectrumPtr scaled_emission(SpectrumPtr spectrum, const JsonValue& object,
                            const ReadContext& context) {
  if (object.has("scale") && object.has("luminance")) {
    object.fail("\"scale\" and \"luminance\" exclude each other");
  }
  if (object.has("scale")) {
    return scaled_spectrum(std::move(spectrum),
                           object.member("scale").number({0.0, kLargestValue}));
  }
  if (!object.has("luminance")) return spectrum;
  const double wanted = object.member("luminance").number({0.0, kLargestValue});
  const double present = xyz_of_emission(*spectrum, observer(context.observer))[1];
  if (!(present > 0.0)) object.fail("\"luminance\" cannot scale a spectrum that no eye sees");
  return scaled_spectrum(std::move(spectrum), wanted / present);
}

// A number, a table or a file: one part of a complex index, or a parameter.
SpectrumPtr read_index_part(const JsonValue& value, const Allowed& allowed,
                            const ReadContext& context) {
  if (value.json().is_number()) return constant_spectrum(value.number(allowed));
  if (!value.json().is_object()) value.fail_found("a number, {\"table\": ...} or {\"file\": ...}");
  value.allow_keys({"table", "file"});
  const std::string kind = kind_of(value, {"table", "file"});
  return kind == "table" ? read_table(value.member(kind), allowed)
                         : read_spectrum_file(value.member(kind), allowed, context);
}

IndexTablePtr inline_index(const JsonValue& value, const ReadContext& context) {
  if (!value.has("eta") && !value.has("k")) return read_composed_index(value, context);
  value.allow_keys({"eta", "k"});
  const SpectrumPtr eta = read_index_part(value.member("eta"), {0.0, 1e6, true}, context);
  const SpectrumPtr k = value.has("k") ? read_index_part(value.member("k"), {0.0, 1e6}, context)
                                       : constant_spectrum(0.0);
  Provenance provenance;
  provenance.name = "inline " + value.place();
  provenance.reference = "eta: " + eta->description() + "; k: " + k->description();
  return index_from_spectra(eta, k, provenance);
}

void require_index_coverage(const IndexTable& table, const JsonValue& value,
                            const ReadContext& context) {
  try {
    const std::string warning = require_coverage(table, context.range, context.policy);
    if (!warning.empty()) context.warnings->push_back(value.place() + ": " + warning);
  } catch (const InputError& failure) {
    value.fail(std::string(failure.what()) +
               "; choose another table or other \"wavelengths\", or say \"extrapolate\": \"clamp\" "
               "to hold its end values");
  }
}

}  // namespace

void collect(const Provenance& provenance, const ReadContext& context) {
  const auto same = [&](const Provenance& p) {
    return p.name == provenance.name && p.file == provenance.file;
  };
  auto& tables = *context.tables;
  if (std::none_of(tables.begin(), tables.end(), same)) tables.push_back(provenance);
}

void remember_file(const std::string& path, const ReadContext& context) {
  if (context.files && !path.empty()) context.files->push_back(path);
}

std::string read_path(const JsonValue& value, const ReadContext& context) {
  if (value.string().empty()) value.fail_found("the path of a file");
  const auto file = find_scene_file(value.string(), context);
  if (!file) value.fail(missing_file_message(value.string(), context));
  remember_file(*file, context);
  return *file;
}

SpectrumPtr read_reflectance(const JsonValue& value, const ReadContext& context) {
  if (value.json().is_number()) return constant_spectrum(value.number({0.0, 1.0}));
  const std::vector<std::string> kinds{"rgb", "table", "file"};
  if (!value.json().is_object())
    value.fail_found("a number 0 to 1, or an object with rgb, table or file");
  value.allow_keys({"rgb", "table", "file", "scale"});
  const std::string kind = kind_of(value, kinds);
  const double scale = value.has("scale") ? value.member("scale").number({0.0, 1e6}) : 1.0;
  const Allowed allowed{0.0, scale > 0.0 ? 1.0 / scale : kLargestValue};
  SpectrumPtr spectrum;
  if (kind == "rgb") {
    spectrum = rgb_reflectance_spectrum(read_rgb(value, std::min(1.0, allowed.max)));
  } else if (kind == "table") {
    spectrum = read_table(value.member(kind), allowed);
  } else {
    spectrum = read_spectrum_file(value.member(kind), allowed, context);
  }
  require_spectrum_coverage(*spectrum, value, context);
  return scale == 1.0 ? spectrum : scaled_spectrum(spectrum, scale);
}

SpectrumPtr read_emission(const JsonValue& value, const ReadContext& context) {
  if (value.json().is_number()) return constant_spectrum(value.number({0.0, kLargestValue}));
  if (!value.json().is_object()) {
    value.fail_found("a number, or an object with rgb, illuminant, blackbody, table or file");
  }
  const SpectrumPtr spectrum = emission_before_scale(value, context);
  require_spectrum_coverage(*spectrum, value, context);
  return scaled_emission(spectrum, value, context);
}

SpectrumPtr read_plain_spectrum(const JsonValue& value, const ReadContext& context) {
  const SpectrumPtr spectrum = read_index_part(value, {-kLargestValue, kLargestValue}, context);
  require_spectrum_coverage(*spectrum, value, context);
  return spectrum;
}

IndexTablePtr read_index(const JsonValue& value, const ReadContext& context) {
  if (value.json().is_number()) return constant_index({value.number({0.0, 1e6, true}), 0.0});
  if (!value.json().is_string() && !value.json().is_object()) {
    value.fail_found(fmt::format(
        "the name of a table as \"main/Au/Johnson\", a number n, or an object with eta and k, {}",
        fmt::join(composed_index_keys(), ", ")));
  }
  const IndexTablePtr table = interpolated(
      value.json().is_string() ? named_index(value, context) : inline_index(value, context),
      context.interpolation);
  require_index_coverage(*table, value, context);
  for (const auto& warning : table->warnings()) {
    context.warnings->push_back(table->provenance().name + ": " + warning);
  }
  collect(table->provenance(), context);
  return table;
}

void require_spectrum_coverage(const Spectrum& spectrum, const JsonValue& value,
                               const ReadContext& context) {
  if (is_covered(spectrum.range(), context.range)) return;
  const std::string sentence =
      fmt::format("{} is known from {:g} to {:g} nm, the scene asks for {:g} to {:g} nm",
                  spectrum.description(), spectrum.range().min_nm, spectrum.range().max_nm,
                  context.range.min_nm, context.range.max_nm);
  if (context.policy == RangePolicy::kError) {
    value.fail(sentence + "; narrow \"wavelengths\" or say \"extrapolate\": \"clamp\"");
  }
  const char* what = value.has("illuminant") ? "it is zero outside" : "its end values are held";
  context.warnings->push_back(value.place() + ": " + sentence + "; " + what);
}

}  // namespace karat
