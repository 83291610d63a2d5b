// SPDX-License-Identifier: MIT
#include "processes/shader_cache.h"

#include <algorithm>
#include <cstdlib>

namespace edgecase {
namespace {

constexpr const char* kFolder = "MESA_SHADER_CACHE_DIR";

// Mesa's variables about its cache; the last two are older names.
constexpr const char* kOfUser[] = {kFolder, "MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DIR",
                                   "MESA_GLSL_CACHE_DISABLE"};

// An absolute path that a variable names; a relative one counts as none (XDG Base Directory
// Specification).
std::optional<std::filesystem::path> folder_of(const char* variable) {
  const char* const value = std::getenv(variable);
  if (value == nullptr || value[0] != '/') return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::filesystem::path> folder_for_caches() {
  if (const auto chosen = folder_of("XDG_CACHE_HOME")) return chosen;
  if (const auto home = folder_of("HOME")) return *home / ".cache";
  return std::nullopt;
}

std::map<std::string, std::string> shader_cache_variables(const std::string& name) {
  const auto is_set = [](const char* variable) { return std::getenv(variable) != nullptr; };
  if (std::ranges::any_of(kOfUser, is_set)) return {};
  const auto caches = folder_for_caches();
  if (!caches) return {};
  return {{kFolder, (*caches / "edgecase" / "mesa" / name).string()},
          {"MESA_SHADER_CACHE_MAX_SIZE", "256M"}};
}

}  // namespace edgecase
