// SPDX-License-Identifier: MIT
//
// Where Mesa keeps what it has compiled of our programs, from run to run: most of what a first run
// costs.
#pragma once

#include <map>
#include <string>

namespace edgecase {

// Mesa's variables for a folder of ours: edgecase/mesa/NAME in the folder for caches
// (XDG_CACHE_HOME, or .cache in HOME), of at most 256 MB. Each `name`, a driver and the version
// that it is made to claim, has its own: Mesa 25.0 crashes where one has another version's
// programs. Empty where the user has chosen by Mesa's own variables, or has no folder for caches.
std::map<std::string, std::string> shader_cache_variables(const std::string& name);

}  // namespace edgecase
