// SPDX-License-Identifier: MIT
//
// What was measured of multisampled targets, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "profile/samples/sample_profile.h"

namespace edgecase {

nlohmann::ordered_json sample_profile_json(const SampleProfile& samples);

}  // namespace edgecase
