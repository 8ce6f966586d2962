#include "apps/karat/nk/index_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "materials/film_stack.h"
#include "materials/index/index_catalogue.h"
#include "render/alloy_presets.h"
#include "render/spectrum_reader.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr const char* kAlloy = "alloy:";

// A made index under the short name that was typed; what it is made of stands in its reference.
class CalledIndex final : public IndexTable {
 public:
  CalledIndex(IndexTablePtr index, const std::string& name)
      : index_(std::move(index)), provenance_(index_->provenance()) {
    provenance_.reference = provenance_.name + "; " + provenance_.reference;
    provenance_.name = name;
  }
  ComplexIndex at(double wavelength_nm) const override { return index_->at(wavelength_nm); }
  WavelengthRange range() const override { return index_->range(); }
  bool has_k() const override { return index_->has_k(); }
  std::vector<SpectrumSample> n_samples() const override { return index_->n_samples(); }
  std::vector<SpectrumSample> k_samples() const override { return index_->k_samples(); }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<std::string>& warnings() const override { return index_->warnings(); }

 private:
  IndexTablePtr index_;
  Provenance provenance_;
};

// Any range will do: the command asks for wavelengths later.
IndexTablePtr read_made_index(const JsonValue& value, const std::string& directory) {
  std::vector<std::string> warnings;
  std::vector<Provenance> tables;
  ReadContext context;
  context.directory = directory;
  context.policy = RangePolicy::kClamp;
  context.warnings = &warnings;
  context.tables = &tables;
  IndexTablePtr index = read_index(value, context);
  if (film_stack_of(*index)) {
    value.fail("a stack of films has no n and k of its own; render it on a conductor");
  }
  return index;
}

IndexTablePtr index_of_file(const std::string& file) {
  const Json json = parse_json(read_text_file(file, kMostBytes), file);
  const JsonValue document(json, file);
  const bool preset = document.has("nk");
  if (preset) document.allow_keys({"description", "source", "nk"});
  return read_made_index(preset ? document.member("nk") : document,
                         std::filesystem::path(file).parent_path().string());
}

}  // namespace

bool is_made_index(const std::string& typed) {
  return typed.starts_with(kAlloy) || typed.starts_with("{") || typed.ends_with(".json");
}

IndexTablePtr index_of_argument(const std::string& typed) {
  if (typed.starts_with(kAlloy)) {
    const Json preset = {{"alloy", typed.substr(std::string(kAlloy).size())}};
    return std::make_shared<CalledIndex>(read_made_index(JsonValue(preset, typed), ""), typed);
  }
  if (typed.starts_with("{")) {
    const Json json = parse_json(typed, "index");
    return read_made_index(JsonValue(json, "index"), "");
  }
  if (typed.ends_with(".json")) {
    return std::make_shared<CalledIndex>(index_of_file(typed), typed);
  }
  const auto alloys = alloy_names();
  try {
    return find_index_table(full_index_name(typed));
  } catch (const InputError&) {
    if (std::find(alloys.begin(), alloys.end(), typed) == alloys.end()) throw;
  }
  throw InputError(fmt::format("\"{}\" is an alloy, no table: write {}{}", typed, kAlloy, typed));
}

std::string index_argument_help() {
  return "main/Au/Johnson, short Au/Johnson, or a file; alloy:rose-gold-18k; an index as in "
         "scenes, '{\"alloy\": ...}' or FILE.json";
}

std::string unit_hint(const std::string& option, WavelengthRange asked, WavelengthRange covered) {
  constexpr double kNmOfUm = 1e3;
  const double least = asked.min_nm * kNmOfUm, largest = asked.max_nm * kNmOfUm;
  if (asked.max_nm >= covered.min_nm || largest < covered.min_nm || least > covered.max_nm) {
    return "";
  }
  if (least == largest) {
    return fmt::format("; {} is in nm: {:g} um is {:g}", option, asked.min_nm, least);
  }
  return fmt::format("; {} is in nm: {:g} to {:g} um is {:g}:{:g}", option, asked.min_nm,
                     asked.max_nm, least, largest);
}

}  // namespace karat
