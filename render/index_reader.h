// Indices in scene files that are made from others or from formulas.
#pragma once

#include <string>
#include <vector>

#include "render/spectrum_reader.h"

namespace karat {

// {"alloy": ...} (alloy_reader.h),
// {"between": {NAME: number, ...}, "at": number}, permittivity linear between neighbours,
// {"drude": ...} and {"lorentz": ...} (oscillator_reader.h),
// {"substrate": index, "layers": [{"nk": index, "thickness_nm": number}, ...]}, the layer that
// light meets first standing first.
// Wherever a NAME stands in an object, a list of objects with "nk" takes any index in its place.
IndexTablePtr read_composed_index(const JsonValue& value, const ReadContext& context);

// The keys that begin these forms.
const std::vector<std::string>& composed_index_keys();

// An index that has n and k, so no stack of films, and what to call it.
struct NamedIndex {
  std::string name;
  IndexTablePtr table;
};

// One entry of {NAME: value, ...} or [{"nk": index, ...}, ...]; a value that is no number is an
// object with `number_key`.
struct IndexMember {
  std::string name;  // empty in a list
  JsonValue value;
};
// Fails at keys of a member that are not "nk" (in a list), `number_key` or in `other_keys`.
std::vector<IndexMember> index_members(const JsonValue& members, const std::string& number_key,
                                       const std::vector<std::string>& other_keys);
NamedIndex read_member(const IndexMember& member, const ReadContext& context);

}  // namespace karat
