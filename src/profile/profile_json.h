// SPDX-License-Identifier: MIT
//
// A profile as JSON, and the policy in it as a policy file.
#pragma once

#include <string>

#include "profile/profile.h"

namespace edgecase {

// {"tool", "renderer", "seed", "scenes_per_kind", "policy", "surfaces": [{"surface", "traits",
// "tables", "clusters", …}]}, indented, the same bytes for the same profile. The smallest scene of
// a cluster is the text of a case file where a case file can say it.
std::string profile_json(const Profile& profile, const std::string& tool);

// What casefile/policy_reader.h reads: the profile as a policy that OpenGL judges, with the
// measured rates as its why.
std::string policy_text(const Profile& profile);

}  // namespace edgecase
