// SPDX-License-Identifier: MIT
//
// The residuals of levels of detail as JSON: a part of profile_json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "profile/textures/texture_residuals.h"

namespace edgecase {

// A list with an object for each kind of ramp and source: the formula that is found with its worst
// scene, and under "formulas" all that are catalogued. Numbers that are none are written as null.
nlohmann::ordered_json level_residuals_json(std::span<const LevelResiduals> rows);

}  // namespace edgecase
