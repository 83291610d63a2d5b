// SPDX-License-Identifier: MIT
//
// Multisampled scenes, and what their renderings say of samples, for the tests of the OpenGL side.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/opengl_test.h"

namespace edgecase {

// A test for each OpenGL renderer, on framebuffer objects with four samples. Softpipe has none, and
// says so: its tests end there.
class MultisampleTest : public OpenGlTest {
 protected:
  static constexpr int kSamples = 4;

  bool has_samples() const { return name().find("softpipe") == std::string::npos; }

  Scene sampled(int width, int height) const {
    Scene scene = blank(width, height);
    scene.target.samples = kSamples;
    return scene;
  }

  // The rendering of a multisampled scene; none where the renderer has no samples and says it.
  std::optional<Rendering> drawn(const Scene& scene) {
    Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) {
      EXPECT_TRUE(has_samples());
      return std::get<Rendering>(std::move(outcome));
    }
    EXPECT_FALSE(has_samples()) << failure->reason;
    EXPECT_EQ(failure->reason, "this driver has no multisampled targets");
    return std::nullopt;
  }

  // Why a scene is not drawn; empty: it is.
  std::string refusal_of(const Scene& scene) {
    const Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) return "";
    EXPECT_EQ(failure->kind, FailureKind::unsupported);
    return failure->reason;
  }
};

#define EDGECASE_ALL_FRAMEBUFFER_OBJECTS \
  ::testing::ValuesIn(places_of_share(opengl_renderer_names(), {Surface::fbo}))

// All samples that the fragments of a pixel cover; no entry where there are no fragments.
inline std::map<std::pair<int, int>, std::uint32_t> coverage_masks(const Rendering& rendering) {
  std::map<std::pair<int, int>, std::uint32_t> masks;
  for (const Fragment& fragment : rendering.fragments)
    masks[{fragment.x, fragment.y}] |= fragment.coverage;
  return masks;
}

// Which samples of a pixel have hits.
inline std::uint32_t hit_mask(const Rendering& rendering, int x, int y) {
  std::uint32_t mask = 0;
  for (int sample = 0; sample < rendering.samples; ++sample)
    if (rendering.hits[rendering.sample_index(x, y, sample)] > 0) mask |= 1u << sample;
  return mask;
}

inline std::vector<int> sample_pixel(const Rendering& rendering, int x, int y, int sample) {
  const auto* first = rendering.sample_pixels.data() + 4 * rendering.sample_index(x, y, sample);
  return {first, first + 4};
}

}  // namespace edgecase
