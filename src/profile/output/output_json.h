// SPDX-License-Identifier: MIT
//
// What was measured of fragment operations, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "profile/output/output_profile.h"

namespace edgecase {

nlohmann::ordered_json output_profile_json(const OutputProfile& output);

}  // namespace edgecase
