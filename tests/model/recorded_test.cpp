// SPDX-License-Identifier: MIT
#include "model/renderer.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace edgecase
