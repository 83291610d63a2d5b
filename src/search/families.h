// SPDX-License-Identifier: MIT
//
// Families: the kinds of random scenes among which a search looks for disagreements.
//
// A family concerns some rules. Each of its scenes depends only on seed, surface and index, on
// every machine, and is built round ties and boundaries where possible; so these three identify a
// find. Generators lie in src/generate.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/rule_id.h"
#include "model/scene.h"

namespace edgecase {

struct Family {
  const char* name;   // "shared-edges"
  const char* about;  // a phrase
  std::vector<RuleId> rules;
  // Its scenes concern only coverage, so nothing else is requested of the renderer.
  bool coverage_only;
  bool has_windows;  // if not, its scenes are of framebuffer objects for either surface
  Scene (*scene)(std::uint64_t seed, Surface surface, std::uint64_t index);
  std::uint64_t scenes = 0;  // the number per surface; 0: unlimited
};

std::span<const Family> all_families();

// Null if there is none of that name.
const Family* find_family(const std::string& name);

// The families selected by names or rule ids (shell globs), in the order of all_families; all
// without patterns. If a pattern selects nothing, a sentence that lists all names.
std::variant<std::vector<const Family*>, std::string> select_families(
    std::span<const std::string> patterns);

}  // namespace edgecase
