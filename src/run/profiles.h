// SPDX-License-Identifier: MIT
//
// Profiles: the choices that renderers were measured to make (edgecase profile). A driver's choices
// change between releases, so a renderer can have a profile for each release that was measured, and
// one for all other releases.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "rules/choices.h"

namespace edgecase {

// The name of the folder with the profiles of a renderer's release: "Mesa-26.2.6", for OpenGL and
// OpenGL ES alike.
std::string release_folder_of(const RendererInfo& info);

// The profiles of one renderer.
class ReleaseProfiles {
 public:
  ReleaseProfiles() = default;
  // One profile, of any release.
  explicit ReleaseProfiles(Policy policy) { add("", std::move(policy)); }

  // `folder`: as of release_folder_of; empty for all releases that have no profile of their own.
  void add(const std::string& folder, Policy policy);
  bool empty() const { return profiles_.empty(); }

  // The profile of the release that `info` reports. Null: there is none.
  const Policy* policy(const RendererInfo& info) const;
  const ResolvedPolicy* resolved(const RendererInfo& info) const;

 private:
  struct Entry {
    Policy policy;
    ResolvedPolicy resolved;
  };
  const Entry* find(const RendererInfo& info) const;

  std::map<std::string, Entry> profiles_;  // by folder
};

using Profiles = std::map<std::string, ReleaseProfiles>;  // by the renderer's name

// The profiles of the renderer that is named so, or none.
const ReleaseProfiles& profiles_of(const Profiles& profiles, const std::string& renderer);

}  // namespace edgecase
