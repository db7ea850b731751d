#pragma once

#include "devo_evo/experiment/parameters.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
// Each reads one type from a value as a source gives it; nothing if it is not of this type. Text must be the value and
// nothing else, in the C locale's notation.
std::optional<bool> asBoolean(const ParameterValue& value);
std::optional<int64_t> asInteger(const ParameterValue& value);
std::optional<double> asReal(const ParameterValue& value);  ///< may be NaN or infinite
std::optional<std::string> asText(const ParameterValue& value);

/// Three whole numbers, from "4x4x3" or [4, 4, 3].
std::optional<std::vector<int64_t>> asGrid(const ParameterValue& value);

/// Numbers, from "0.5,2", "[0.5, 2]", one number or a list of whole numbers; none from "".
std::optional<std::vector<double>> asReals(const ParameterValue& value);

/// The value as messages show it.
std::string describe(const ParameterValue& value);

/// Text as messages show it: its beginning, if it is long.
std::string abbreviated(const std::string& text);
}  // namespace devo_evo
