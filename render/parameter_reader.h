// From JSON to checked Parameters, by the list that a registered type gives.
#pragma once

#include <string>
#include <vector>

#include "materials/parameters.h"
#include "render/spectrum_reader.h"

namespace karat {

// Reads the parameters listed in `infos` from an object. Keys of the object that are neither listed
// nor in `other_keys` are errors; absent ones get their default. Throws InputError.
Parameters read_parameters(const JsonValue& object, const std::vector<ParameterInfo>& infos,
                           const std::vector<std::string>& other_keys, const ReadContext& context);

// The JSON schema of one parameter.
Json parameter_schema(const ParameterInfo& info);

}  // namespace karat
