// SPDX-License-Identifier: MIT
//
// A profile as a table for people.
#pragma once

#include <string>

#include "profile/profile.h"

namespace edgecase {

// "100 %" for all, else rounded down, so that one scene of many still shows: "99.99 %".
std::string percent(const Rate& rate);

// Who it is, then per surface: traits, ownership tables, clusters of counter-examples (at most
// `most_clusters` of each surface; how many more there are is said).
std::string profile_text(const Profile& profile, std::size_t most_clusters);

// The same in at most ten lines: who it is, what was asked, of each surface how many traits are
// followed throughout, the three that are followed least, and what is outside the specification;
// then what decides over coverage.
std::string profile_summary(const Profile& profile);

}  // namespace edgecase
