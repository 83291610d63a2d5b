// SPDX-License-Identifier: MIT
#include "wire/rendering_json.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

TEST(RenderingJson, HasTheDocumentedForm) {
  Rendering rendering;
  rendering.width = 1;
  rendering.height = 1;
  rendering.pixels = {1, 2, 3, 255};
  Fragment told;
  told.depth = 0.5;
  told.color = {0.25, 0, 1, 1};
  Fragment silent;
  silent.primitive = 1;
  silent.has_color = false;
  silent.has_depth = false;
  rendering.fragments = {told, silent};
  EXPECT_EQ(rendering_json("a/b:x=1", rendering),
            R"({"id":"a/b:x=1","width":1,"height":1,"samples":1,"fragments":[)"
            R"({"x":0,"y":0,"primitive":0,"coverage":1,"depth":0.5,"color":[0.25,0,1,1]},)"
            R"({"x":0,"y":0,"primitive":1,"coverage":1}],"pixels":[1,2,3,255]})");
}

}  // namespace
}  // namespace edgecase
