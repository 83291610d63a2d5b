// SPDX-License-Identifier: MIT
//
// What is wrong with values of a scene that depend on each other, although each is in its range.
// Case files and request lines are held to the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

struct SceneFault {
  std::string text;    // of the object that is wrong
  std::string remedy;  // for who writes a case file
};

// Whether every level exists that a mip filter may use.
bool has_whole_chain(const Texture& texture);

// Of a sampler's levels (GL 4.6 core, 8.14.3 and 8.17); `texture`: null if it is unknown.
std::vector<SceneFault> faults_of(const Sampler& sampler, const Texture* texture);

// Whether all passes together are more work than kMaxPassWork.
std::optional<SceneFault> fault_of_passes(const Scene& scene);

}  // namespace edgecase
