// SPDX-License-Identifier: MIT
#include "run/profiles.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

RendererInfo info_of(const std::string& version) {
  RendererInfo info;
  info.name = "egl:llvmpipe";
  info.version = version;
  return info;
}

Policy policy_of(const std::string& name) {
  Policy policy;
  policy.name = name;
  return policy;
}

TEST(Profiles, AFolderIsNamedAfterARelease) {
  EXPECT_EQ(release_folder_of(info_of("4.6 (Core Profile) Mesa 26.2.6-1")), "Mesa-26.2.6");
  EXPECT_EQ(release_folder_of(info_of("OpenGL ES 3.2 Mesa 25.0.7-2+deb13u1")), "Mesa-25.0.7");
  EXPECT_EQ(release_folder_of(info_of("")), "unversioned");
}

TEST(Profiles, OfTheReleaseBeforeThatOfAnyOther) {
  ReleaseProfiles profiles(policy_of("usual"));
  profiles.add("Mesa-26.2.6", policy_of("newer"));
  EXPECT_EQ(profiles.policy(info_of("4.6 (Core Profile) Mesa 26.2.6-1"))->name, "newer");
  EXPECT_EQ(profiles.policy(info_of("4.6 (Core Profile) Mesa 26.2.7"))->name, "usual");
  EXPECT_NE(profiles.resolved(info_of("4.6 (Core Profile) Mesa 26.2.6")),
            profiles.resolved(info_of("4.5 (Core Profile) Mesa 22.3.6")));
}

TEST(Profiles, NoneForARendererOrReleaseThatWasNotMeasured) {
  const Profiles none;
  EXPECT_EQ(profiles_of(none, "egl:llvmpipe").policy(info_of("4.5 Mesa 22.3.6")), nullptr);
  ReleaseProfiles newer;
  newer.add("Mesa-26.2.6", policy_of("newer"));
  EXPECT_EQ(newer.policy(info_of("4.5 (Core Profile) Mesa 22.3.6")), nullptr);
  EXPECT_EQ(newer.resolved(info_of("4.5 (Core Profile) Mesa 22.3.6")), nullptr);
}

}  // namespace
}  // namespace edgecase
