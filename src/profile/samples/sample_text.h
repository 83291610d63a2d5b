// SPDX-License-Identifier: MIT
//
// What was measured of multisampled targets, as text for people.
#pragma once

#include <string>

#include "profile/samples/sample_profile.h"

namespace edgecase {

std::string sample_profile_text(const SampleProfile& samples);

}  // namespace edgecase
