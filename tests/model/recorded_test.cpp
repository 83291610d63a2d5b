// SPDX-License-Identifier: MIT
#include "model/renderer.h"

#include <gtest/gtest.h>

#include <string>

namespace edgecase {
namespace {

TEST(Recorded, ARecordingIsKnownAsWhatItRecorded) {
  RendererInfo info;
  info.name = "recording:some.rec";
  EXPECT_EQ(known_as(info), "recording:some.rec");
  info.traits[kRecordedTrait] = "egl:device0";
  EXPECT_EQ(known_as(info), "egl:device0");
}

// A program may claim any trait; it stays what it is.
TEST(Recorded, OthersAreKnownByTheirNames) {
  RendererInfo info;
  info.name = "exec:liar";
  info.traits[kRecordedTrait] = "osmesa:llvmpipe";
  EXPECT_EQ(known_as(info), "exec:liar");
}

TEST(OwnNames, AreShortAndPlain) {
  for (const char* name : {"mine", "a", "7", "My_own-2.0"}) EXPECT_TRUE(is_own_name(name)) << name;
  for (const char* name : {"", "exact", "my own", "exec:./r", ".mine", "-m", "_m", "a/b", "a=b"})
    EXPECT_FALSE(is_own_name(name)) << name;
  EXPECT_TRUE(is_own_name(std::string(64, 'a')));
  EXPECT_FALSE(is_own_name(std::string(65, 'a')));
}

TEST(OwnNames, AProgramIsKnownByItsNameAndADriverByItsAddress) {
  RendererInfo info;
  info.name = "mine";
  info.traits[kAddressTrait] = "exec:./r";
  EXPECT_EQ(address_of(info), "exec:./r");
  EXPECT_EQ(asked_as(info), "mine=exec:./r");
  EXPECT_EQ(known_as(info), "mine");
  info.traits[kAddressTrait] = "osmesa:llvmpipe";
  EXPECT_EQ(known_as(info), "osmesa:llvmpipe");
  info.traits[kAddressTrait] = "recording:a.rec";
  EXPECT_EQ(known_as(info), "mine");
  info.traits[kRecordedTrait] = "exec:./r";
  EXPECT_EQ(known_as(info), "mine");
  info.traits[kRecordedTrait] = "egl:device0";
  EXPECT_EQ(known_as(info), "egl:device0");
}

// A program may claim this trait, too.
TEST(OwnNames, WithoutOneTheNameIsTheAddress) {
  RendererInfo info;
  info.name = "exec:liar";
  info.traits[kAddressTrait] = "osmesa:llvmpipe";
  EXPECT_EQ(address_of(info), "exec:liar");
  EXPECT_EQ(asked_as(info), "exec:liar");
  EXPECT_EQ(known_as(info), "exec:liar");
}

}  // namespace
}  // namespace edgecase
