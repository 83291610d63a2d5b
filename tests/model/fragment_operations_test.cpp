// SPDX-License-Identifier: MIT
//
// Fragment operations: names, comparisons, and whether a scene has any.
#include "model/fragment_operations.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {
namespace {

// The first `count` values of an enumeration have names of their own that read back, in the order
// of the header, and there are no more.
template <class Enum>
void expect_names(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = static_cast<Enum>(i);
    EXPECT_EQ(name_of(value), names[i]);
    // Start from another value, so that a parse that does nothing is found out.
    auto read = static_cast<Enum>((i + 1) % names.size());
    EXPECT_TRUE(parse_name(names[i], read)) << names[i];
    EXPECT_EQ(read, value);
  }
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_STREQ(name_of(static_cast<Enum>(names.size())), "?");
  for (const std::string wrong : {"", "?", "Less", "less ", "src1_color", "both"}) {
    auto untouched = static_cast<Enum>(1);
    EXPECT_FALSE(parse_name(wrong, untouched)) << wrong;
    EXPECT_EQ(untouched, static_cast<Enum>(1));
  }
}

TEST(FragmentOperations, NamesReadBack) {
  expect_names<CompareFunction>(
      {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"});
  expect_names<StencilOperation>(
      {"keep", "zero", "replace", "incr", "incr_wrap", "decr", "decr_wrap", "invert"});
  expect_names<BlendFactor>({"zero", "one", "src_color", "one_minus_src_color", "dst_color",
                             "one_minus_dst_color", "src_alpha", "one_minus_src_alpha", "dst_alpha",
                             "one_minus_dst_alpha", "constant_color", "one_minus_constant_color",
                             "constant_alpha", "one_minus_constant_alpha", "src_alpha_saturate"});
  expect_names<BlendEquation>({"add", "subtract", "reverse_subtract", "min", "max"});
  expect_names<FrontFace>({"ccw", "cw"});
  expect_names<CullMode>({"none", "front", "back", "front_and_back"});
  expect_names<StencilFormat>({"none", "stencil8"});
}

TEST(FragmentOperations, ComparisonsHoldAsTheyAreCalled) {
  using enum CompareFunction;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      const auto compares = [&](CompareFunction function) {
        return holds(function, a < b, a == b);
      };
      EXPECT_FALSE(compares(never));
      EXPECT_EQ(compares(less), a < b);
      EXPECT_EQ(compares(equal), a == b);
      EXPECT_EQ(compares(lequal), a <= b);
      EXPECT_EQ(compares(greater), a > b);
      EXPECT_EQ(compares(notequal), a != b);
      EXPECT_EQ(compares(gequal), a >= b);
      EXPECT_TRUE(compares(always));
    }
  }
}

Scene plain_scene() {
  Scene scene;
  scene.target.width = scene.target.height = 4;
  scene.target.depth = DepthFormat::depth24;
  scene.draws.resize(2);
  return scene;
}

using Change = std::function<void(Scene&)>;

const std::vector<Change> kOperations{
    [](Scene& s) { s.target.stencil = StencilFormat::stencil8; },
    [](Scene& s) { s.target.clear_depth = 0.5F; },
    [](Scene& s) { s.draws[1].operations.stencil = StencilTest(); },
    [](Scene& s) { s.draws[1].operations.depth.function = CompareFunction::less; },
    [](Scene& s) { s.draws[1].operations.depth.write = false; },
    [](Scene& s) { s.draws[1].operations.blending = Blending(); },
    [](Scene& s) { s.draws[0].operations.color_mask[0] = false; },
    [](Scene& s) { s.draws[0].operations.color_mask[1] = false; },
    [](Scene& s) { s.draws[0].operations.color_mask[2] = false; },
    [](Scene& s) { s.draws[0].operations.color_mask[3] = false; },
};

// What leaves each fragment to be written over the one before.
const std::vector<Change> kOthers{
    [](Scene& s) { s.target.clear_stencil = 1; },
    [](Scene& s) { s.depth_range.near = 0.5F; },
    [](Scene& s) { s.depth_range.far = 0.5F; },
    [](Scene& s) { s.draws[1].front_face = FrontFace::cw; },
    [](Scene& s) { s.draws[1].cull = CullMode::back; },
    [](Scene& s) { s.draws[1].polygon_offset = PolygonOffset(); },
};

TEST(FragmentOperations, ASceneHasThemInEachOfTheseWays) {
  EXPECT_FALSE(has_fragment_operations(Scene()));
  EXPECT_FALSE(has_fragment_operations(plain_scene()));
  for (std::size_t i = 0; i < kOperations.size(); ++i) {
    Scene scene = plain_scene();
    kOperations[i](scene);
    EXPECT_TRUE(has_fragment_operations(scene)) << i;
  }
  for (std::size_t i = 0; i < kOthers.size(); ++i) {
    Scene scene = plain_scene();
    kOthers[i](scene);
    EXPECT_FALSE(has_fragment_operations(scene)) << i;
  }
}

void expect_all_differ(const Scene& scene, const std::vector<Change>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene other = scene;
    changes[i](other);
    EXPECT_FALSE(same_scene(scene, other)) << i;
    EXPECT_FALSE(same_scene(other, scene)) << i;
    EXPECT_TRUE(same_scene(other, other)) << i;
  }
}

TEST(FragmentOperations, EachMakesAnotherScene) {
  expect_all_differ(plain_scene(), kOperations);
  expect_all_differ(plain_scene(), kOthers);
}

TEST(FragmentOperations, AreDescribed) {
  Scene scene;
  scene.target.width = scene.target.height = 4;
  scene.target.stencil = StencilFormat::stencil8;
  Draw draw;
  draw.primitive = Primitive::points;
  draw.vertices.resize(1);
  scene.draws = {draw};
  EXPECT_EQ(scene_text(scene), "point (0, 0), 4x4, stencil8");
  Draw& own = scene.draws[0];
  own.front_face = FrontFace::cw;
  own.cull = CullMode::front_and_back;
  own.polygon_offset = PolygonOffset();
  own.operations = {StencilTest(), {CompareFunction::less, false}, Blending(), {true, false, true}};
  EXPECT_EQ(scene_text(scene),
            "point (0, 0), front faces cw, culled front and back, offset, stencil test, depth "
            "less, depth not written, blended, mask r-b-, 4x4, stencil8");
}

TEST(FragmentOperations, EachPartOfThemMakesAnotherScene) {
  Scene scene = plain_scene();
  Draw& draw = scene.draws[0];
  draw.operations.stencil = StencilTest();
  draw.operations.blending = Blending();
  draw.polygon_offset = PolygonOffset();
  const auto face = [](StencilFace StencilTest::*side, const std::function<void(StencilFace&)>& f) {
    return [=](Scene& s) { f((*s.draws[0].operations.stencil).*side); };
  };
  std::vector<Change> changes{
      [](Scene& s) { s.draws[0].operations.blending->color.equation = BlendEquation::min; },
      [](Scene& s) { s.draws[0].operations.blending->color.source = BlendFactor::zero; },
      [](Scene& s) { s.draws[0].operations.blending->color.destination = BlendFactor::one; },
      [](Scene& s) { s.draws[0].operations.blending->alpha.equation = BlendEquation::max; },
      [](Scene& s) { s.draws[0].operations.blending->constant[3] = 1; },
      [](Scene& s) { s.draws[0].polygon_offset->factor = 1; },
      [](Scene& s) { s.draws[0].polygon_offset->units = 1; },
      [](Scene& s) { s.draws[0].polygon_offset->clamp = 1; },
  };
  for (StencilFace StencilTest::*side : {&StencilTest::front, &StencilTest::back}) {
    changes.push_back(face(side, [](StencilFace& f) { f.function = CompareFunction::less; }));
    changes.push_back(face(side, [](StencilFace& f) { f.reference = 1; }));
    changes.push_back(face(side, [](StencilFace& f) { f.read_mask = 1; }));
    changes.push_back(face(side, [](StencilFace& f) { f.write_mask = 1; }));
    changes.push_back(face(side, [](StencilFace& f) { f.fail = StencilOperation::zero; }));
    changes.push_back(face(side, [](StencilFace& f) { f.depth_fail = StencilOperation::zero; }));
    changes.push_back(face(side, [](StencilFace& f) { f.pass = StencilOperation::zero; }));
  }
  expect_all_differ(scene, changes);
}

}  // namespace
}  // namespace edgecase
