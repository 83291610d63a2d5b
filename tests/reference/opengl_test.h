// SPDX-License-Identifier: MIT
//
// A test for each OpenGL renderer and each surface: OpenGlTest, to be derived from and instantiated
// with EDGECASE_ALL_PLACES.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "run/renderer_names.h"
#include "tests/reference/drawings.h"

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

class OpenGlTest : public ::testing::TestWithParam<std::tuple<std::string, Surface>> {
 protected:
  // A system without the library skips; a library that does not work is a failure.
  void SetUp() override {
    const Outcome outcome = render_outcome(renderer(), blank(1, 1));
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) return;
    if (failure->reason.find("cannot be opened") != std::string::npos)
      GTEST_SKIP() << failure->reason;
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

#define EDGECASE_ALL_PLACES                                        \
  ::testing::Combine(::testing::ValuesIn(opengl_renderer_names()), \
                     ::testing::Values(Surface::fbo, Surface::window))

}  // namespace edgecase
