// SPDX-License-Identifier: MIT
//
// Where things are kept from run to run: the user's folder for caches, and in it what Mesa has
// compiled of our programs, which is most of what a first run costs.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace edgecase {

// The folder that XDG_CACHE_HOME names, or .cache in HOME; it may be missing. Nothing where neither
// is an absolute path.
std::optional<std::filesystem::path> folder_for_caches();

// Mesa's variables for a folder of ours: edgecase/mesa/NAME in the folder for caches
// (XDG_CACHE_HOME, or .cache in HOME), of at most 256 MB. Each `name`, a driver and the version
// that it is made to claim, has its own: Mesa 25.0 crashes where one has another version's
// programs. Empty where the user has chosen by Mesa's own variables, or has no folder for caches.
std::map<std::string, std::string> shader_cache_variables(const std::string& name);

}  // namespace edgecase
