// SPDX-License-Identifier: MIT
//
// The errors of values as JSON: a part of profile_json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "profile/values/value_errors.h"

namespace edgecase {

// A list with an object for each row. Numbers that are none are written as null.
nlohmann::ordered_json value_errors_json(std::span<const ValueErrors> rows);

}  // namespace edgecase
