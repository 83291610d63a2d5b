// SPDX-License-Identifier: MIT
#include "run/profiles.h"

#include <algorithm>
#include <utility>

#include "results/known_faults.h"

namespace edgecase {

std::string release_folder_of(const RendererInfo& info) {
  Release release = release_of(info);
  release.is_es = false;
  std::string folder = text_of(release);
  std::ranges::replace_if(
      folder, [](char c) { return c == ' ' || c == '/'; }, '-');
  return folder;
}

void ReleaseProfiles::add(const std::string& folder, Policy policy) {
  ResolvedPolicy resolved(policy);
  profiles_.insert_or_assign(folder, Entry{std::move(policy), std::move(resolved)});
}

const ReleaseProfiles::Entry* ReleaseProfiles::find(const RendererInfo& info) const {
  // A release is read from text, which is slow beside a small scene.
  const bool has_releases = profiles_.size() > profiles_.count("");
  auto found = has_releases ? profiles_.find(release_folder_of(info)) : profiles_.end();
  if (found == profiles_.end()) found = profiles_.find("");
  return found == profiles_.end() ? nullptr : &found->second;
}

const Policy* ReleaseProfiles::policy(const RendererInfo& info) const {
  const Entry* entry = find(info);
  return entry ? &entry->policy : nullptr;
}

const ResolvedPolicy* ReleaseProfiles::resolved(const RendererInfo& info) const {
  const Entry* entry = find(info);
  return entry ? &entry->resolved : nullptr;
}

const ReleaseProfiles& profiles_of(const Profiles& profiles, const std::string& renderer) {
  static const ReleaseProfiles kNone;
  const auto found = profiles.find(renderer);
  return found == profiles.end() ? kNone : found->second;
}

}  // namespace edgecase
