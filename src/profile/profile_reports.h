// SPDX-License-Identifier: MIT
//
// A profile as text for people, as JSON, and as a policy file.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>

#include "profile/profile.h"

namespace edgecase {

// The renderer, then per surface: traits, tables of evidence, ownership tables, and clusters of
// counter-examples (at most `most_clusters` per surface, then the number of others).
std::string profile_text(const Profile& profile, std::size_t most_clusters);

// At most ten lines: the renderer and the measurement; for each surface how many traits hold in
// every scene, the three that are followed least, and what is outside the specification; then the
// rules that decide coverage.
std::string profile_summary(const Profile& profile);

// {"tool", "renderer", "seed", "scenes_per_kind", "policy", "surfaces": [{"surface", "traits",
// "tables", "clusters", …}]}, indented; equal profiles give equal bytes. The smallest scene of a
// cluster is the text of a case file if one can express it. NaN and infinity are null.
std::string profile_json(const Profile& profile, const std::string& tool);

// A file for casefile/policy_reader.h: the profile as a policy with OpenGL's latitude, and the
// measured rates as its "why".
std::string policy_text(const Profile& profile);

// Parts of the text: tables, each line with its worst scenes. Empty if nothing was measured.
std::string value_errors_text(std::span<const ValueErrors> rows);
std::string level_residuals_text(std::span<const LevelResiduals> rows);
std::string sample_profile_text(const SampleProfile& samples);
std::string output_profile_text(const OutputProfile& output);

// The lines of a text under construction.
using Buffer = fmt::memory_buffer;
template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}
void print_renderer(Buffer& out, const Profile& profile);  // the first line of both texts

// The same parts of the JSON.
nlohmann::ordered_json value_errors_json(std::span<const ValueErrors> rows);
nlohmann::ordered_json level_residuals_json(std::span<const LevelResiduals> rows);
nlohmann::ordered_json sample_profile_json(const SampleProfile& samples);
nlohmann::ordered_json output_profile_json(const OutputProfile& output);

}  // namespace edgecase
