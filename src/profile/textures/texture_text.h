// SPDX-License-Identifier: MIT
//
// The residuals of levels of detail for people: a part of profile_text.
#pragma once

#include <span>
#include <string>

#include "profile/textures/texture_residuals.h"

namespace edgecase {

// Two tables: the formula that is found, a line for each kind of ramp and source, each with its
// worst scene; and the largest residual of every catalogued formula, over all kinds of ramps. Empty
// without rows.
std::string level_residuals_text(std::span<const LevelResiduals> rows);

}  // namespace edgecase
