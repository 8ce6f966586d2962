#include "render/index_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "materials/film_stack.h"
#include "materials/index/index_mixture.h"
#include "render/alloy_reader.h"
#include "render/oscillator_reader.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::size_t kMostMembers = 1000;

// Problems that concern a whole value get its place.
template <typename Create>
IndexTablePtr created(const JsonValue& value, Create&& create) {
  try {
    return create();
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

IndexTablePtr read_plain_index(const JsonValue& value, const ReadContext& context) {
  IndexTablePtr table = read_index(value, context);
  if (film_stack_of(*table)) {
    value.fail(
        "a stack of films has no n and k of its own; it can only be the \"nk\" of a "
        "conductor, or a substrate");
  }
  return table;
}

// --- between

struct AtValue {
  IndexMember member;
  double value;
};

std::vector<AtValue> sorted_values(const JsonValue& between) {
  std::vector<AtValue> values;
  for (IndexMember& member : index_members(between, "value", {})) {
    const JsonValue& given = member.value;
    const double number =
        (given.json().is_number() ? given : given.member("value")).number({-1e30, 1e30});
    values.push_back({std::move(member), number});
  }
  if (values.size() < 2) between.fail("at least two tables are needed to go between");
  std::stable_sort(values.begin(), values.end(),
                   [](const AtValue& a, const AtValue& b) { return a.value < b.value; });
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i].value > values[i - 1].value) continue;
    values[i].member.value.fail(fmt::format("two tables are given for {:g}", values[i].value));
  }
  return values;
}

// Tables that `at` does not need are read too, so that a wrong name never goes unseen; they leave
// nothing in the image's metadata.
void check_unused(const AtValue& unused, const ReadContext& context) {
  std::vector<std::string> warnings;
  std::vector<Provenance> tables;
  ReadContext quiet = context;
  quiet.policy = RangePolicy::kClamp;
  quiet.warnings = &warnings;
  quiet.tables = &tables;
  read_member(unused.member, quiet);
}

IndexTablePtr read_between(const JsonValue& value, const ReadContext& context) {
  value.allow_keys({"between", "at"});
  const std::vector<AtValue> values = sorted_values(value.member("between"));
  const double at = value.member("at").number();
  if (!(at >= values.front().value && at <= values.back().value)) {
    value.member("at").fail_found(
        fmt::format("{:g} to {:g}, between the values of the tables; nothing is extrapolated",
                    values.front().value, values.back().value));
  }
  const auto above = std::find_if(values.begin() + 1, values.end(),
                                  [&](const AtValue& v) { return v.value >= at; });
  const AtValue &low = *std::prev(above), &high = *above;
  for (const AtValue& table : values) {
    if (&table != &low && &table != &high) check_unused(table, context);
  }
  const NamedIndex a = read_member(low.member, context), b = read_member(high.member, context);
  Provenance provenance;
  provenance.name = fmt::format("at {:g} between {} ({:g}) and {} ({:g})", at, a.name, low.value,
                                b.name, high.value);
  provenance.reference = "permittivity linear between the two tables";
  return created(value, [&] {
    return index_between({{a.table, low.value}, {b.table, high.value}}, at, provenance);
  });
}

// --- layers

IndexTablePtr read_layers(const JsonValue& value, const ReadContext& context) {
  value.allow_keys({"substrate", "layers"});
  const JsonValue layers = value.member("layers");
  if (layers.require_array().size() == 0 || layers.size() > kMostMembers) {
    layers.fail_found(fmt::format("a list of 1 to {} layers", kMostMembers));
  }
  FilmStack stack;
  Provenance provenance;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const JsonValue layer = layers.element(i);
    layer.allow_keys({"nk", "thickness_nm"});
    const double thickness_nm = layer.member("thickness_nm").number({0.0, kThickestFilmsNm});
    stack.layers.push_back({read_plain_index(layer.member("nk"), context), thickness_nm});
    provenance.name +=
        fmt::format("{:g} nm {} on ", thickness_nm, stack.layers.back().index->provenance().name);
  }
  const IndexTablePtr substrate = read_index(value.member("substrate"), context);
  provenance.name += substrate->provenance().name;
  provenance.reference = "thin films by the transfer-matrix method, Born and Wolf, section 1.6";
  if (const FilmStack* below = film_stack_of(*substrate)) {
    stack.layers.insert(stack.layers.end(), below->layers.begin(), below->layers.end());
    stack.substrate = below->substrate;
  } else {
    stack.substrate = substrate;
  }
  return created(value, [&] { return layered_index(std::move(stack), std::move(provenance)); });
}

using Reader = std::function<IndexTablePtr(const JsonValue&, const ReadContext&)>;
const std::vector<std::pair<std::string, Reader>>& readers() {
  static const std::vector<std::pair<std::string, Reader>> all{
      {"alloy", read_alloy},     {"between", read_between}, {"drude", read_drude},
      {"lorentz", read_lorentz}, {"layers", read_layers},   {"substrate", read_layers}};
  return all;
}

}  // namespace

IndexTablePtr read_composed_index(const JsonValue& value, const ReadContext& context) {
  for (const auto& [key, reader] : readers()) {
    if (value.has(key)) return reader(value, context);
  }
  std::vector<std::string> known{"eta", "k"};
  known.insert(known.end(), composed_index_keys().begin(), composed_index_keys().end());
  value.allow_keys(known);
  value.fail_found(fmt::format("one of the keys {}", fmt::join(known, ", ")));
}

const std::vector<std::string>& composed_index_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> names;
    for (const auto& [key, reader] : readers()) names.push_back(key);
    return names;
  }();
  return keys;
}

std::vector<IndexMember> index_members(const JsonValue& members, const std::string& number_key,
                                       const std::vector<std::string>& other_keys) {
  const bool list = members.json().is_array();
  if (!list) members.require_object();
  if (members.size() > kMostMembers) {
    members.fail(fmt::format("{} entries, allowed: at most {}", members.size(), kMostMembers));
  }
  std::vector<std::string> known = other_keys;
  known.push_back(number_key);
  if (list) known.push_back("nk");
  std::vector<IndexMember> found;
  for (std::size_t i = 0; list && i < members.size(); ++i) {
    found.push_back({"", members.element(i)});
    found.back().value.allow_keys(known);
  }
  if (list) return found;
  for (const std::string& name : members.keys()) {
    found.push_back({name, members.member(name)});
    const JsonValue& value = found.back().value;
    if (value.json().is_number()) continue;
    if (!value.json().is_object()) {
      value.fail_found(fmt::format("a number, or an object with \"{}\"", number_key));
    }
    value.allow_keys(known);
  }
  return found;
}

NamedIndex read_member(const IndexMember& member, const ReadContext& context) {
  if (!member.name.empty()) {
    const Json name = member.name;
    const JsonValue value(name, member.value.file(), member.value.place());
    return {member.name, read_plain_index(value, context)};
  }
  const JsonValue nk = member.value.member("nk");
  const IndexTablePtr table = read_plain_index(nk, context);
  return {nk.json().is_string() ? nk.string() : table->provenance().name, table};
}

}  // namespace karat
