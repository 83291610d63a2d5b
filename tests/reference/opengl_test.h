// SPDX-License-Identifier: MIT
//
// A test for each OpenGL renderer and each surface: OpenGlTest, to be derived from and instantiated
// with EDGECASE_ALL_PLACES.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "run/renderers.h"
#include "tests/reference/drawings.h"
#include "tests/support/share.h"

namespace edgecase {

// One process for each renderer and the whole program: starting is the expensive part.
inline ProcessRenderer& shared_renderer(const std::string& name) {
  static std::map<std::string, std::unique_ptr<ProcessRenderer>> renderers;
  auto& renderer = renderers[name];
  if (renderer == nullptr) {
    auto spec = std::get<ProcessSpec>(find_renderer(name, EDGECASE_BIN));
    // What is drawn is tested, not how fast on a machine that builds something beside.
    spec.timeout = std::chrono::minutes(2);
    renderer = std::make_unique<ProcessRenderer>(spec);
  }
  return *renderer;
}

// True if Mesa's release begins like this: "26." of "4.5 (Core Profile) Mesa 26.2.6-1".
inline bool is_mesa(const std::string& release) {
  ProcessRenderer& softpipe = shared_renderer("egl:softpipe");
  render_outcome(softpipe, blank_scene(1, 1));
  return softpipe.info().version.find("Mesa " + release) != std::string::npos;
}

// True if a system has no such renderer, and no fault is to blame: it lacks the library, or its
// zink refuses SwiftShader.
inline bool is_lacking(const std::string& renderer, const Failure& failure) {
  const auto says = [&](const char* text) {
    return failure.reason.find(text) != std::string::npos;
  };
  return says("cannot be opened") ||
         (renderer == "egl:zink-swiftshader" && is_mesa("26.") && says("cannot be initialised"));
}

class OpenGlTest : public ::testing::TestWithParam<std::tuple<std::string, Surface>> {
 protected:
  // A system that lacks it skips; one that does not work is a failure.
  void SetUp() override {
    const Outcome outcome = render_outcome(renderer(), blank(1, 1));
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) return;
    if (is_lacking(name(), *failure)) GTEST_SKIP() << failure->reason;
    FAIL() << failure->reason;
  }

  std::string name() const { return std::get<0>(GetParam()); }
  ProcessRenderer& renderer() { return shared_renderer(name()); }

  // A scene on the surface under test.
  Scene blank(int width, int height) const {
    Scene scene = blank_scene(width, height);
    scene.target.surface = std::get<1>(GetParam());
    return scene;
  }
};

inline std::string place_name(const ::testing::TestParamInfo<OpenGlTest::ParamType>& test) {
  std::string name = std::get<0>(test.param);
  for (char& c : name)
    if (c == ':' || c == '-') c = '_';
  return name + "_" + name_of(std::get<1>(test.param));
}

// The places of this share, of each of these renderers on each of these surfaces: at least one, and
// of the next test others. Softpipe lacks much of what is tested, so that where it is alone the
// first place is asked too. To be called once for each test, as gtest does.
inline std::vector<OpenGlTest::ParamType> places_of_share(const std::vector<std::string>& renderers,
                                                          const std::vector<Surface>& surfaces) {
  std::vector<OpenGlTest::ParamType> all, mine;
  for (const std::string& renderer : renderers)
    for (const Surface surface : surfaces) all.emplace_back(renderer, surface);
  static std::size_t tests = 0;
  ++tests;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_in_share_of_few((i + tests) % all.size(), all.size())) mine.push_back(all[i]);
  if (std::all_of(mine.begin(), mine.end(), [](const OpenGlTest::ParamType& place) {
        return std::get<0>(place).ends_with("softpipe");
      }))
    mine.push_back(all.front());
  return mine;
}

#define EDGECASE_ALL_PLACES \
  ::testing::ValuesIn(places_of_share(opengl_renderer_names(), {Surface::fbo, Surface::window}))

}  // namespace edgecase
