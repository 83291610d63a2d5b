// SPDX-License-Identifier: MIT
//
// Families: the kinds of random scenes among which a search looks for disagreements.
//
// A family is about some rules. Each of its scenes is a function of seed, surface and index alone,
// on every machine, built round ties and boundaries where it can be; so a find is named by these
// three. Most generators are those by which renderers are measured (src/generate, src/profile).
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
  // What its scenes are about is coverage: nothing else is asked of the renderer.
  bool coverage_only;
  bool has_windows;  // else its scenes are of framebuffer objects, whatever surface is given
  Scene (*scene)(std::uint64_t seed, Surface surface, std::uint64_t index);
  std::uint64_t scenes = 0;  // how many there are, on each surface; 0: there is no end of them
};

std::span<const Family> all_families();

// Null when there is none of that name.
const Family* find_family(const std::string& name);

// The families that names or rule ids mean, shell globs allowed, in the order of all_families and
// each once; none given: all. A sentence with all that is known where one means nothing.
std::variant<std::vector<const Family*>, std::string> select_families(
    std::span<const std::string> patterns);

}  // namespace edgecase
