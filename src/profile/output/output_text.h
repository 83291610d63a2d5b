// SPDX-License-Identifier: MIT
//
// What was measured of fragment operations, as text for people.
#pragma once

#include <string>

#include "profile/output/output_profile.h"

namespace edgecase {

std::string output_profile_text(const OutputProfile& output);

}  // namespace edgecase
