// SPDX-License-Identifier: MIT
//
// Scenes with fragment operations, for the tests of the OpenGL side: rows of pixels, each with its
// own draws.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/opengl_test.h"

namespace edgecase {

// A test for each OpenGL renderer and each surface, where some lack depth or stencil buffers. That
// they lack no others is for FragmentOperationsTest.EveryPlaceHasTheBuffersThatItIsKnownToHave.
class OperationsTest : public OpenGlTest {
 protected:
  // A row of pixels with these buffers, in a viewport of a power of two.
  Scene row(int width, DepthFormat depth, StencilFormat stencil) const {
    Scene scene = blank(width, 1);
    scene.viewport = {0, 0, 256, 1};
    scene.target.depth = depth;
    scene.target.stencil = stencil;
    return scene;
  }

  // The rendering of a scene; none where the place lacks the buffers and says so.
  std::optional<Rendering> drawn(const Scene& scene) {
    Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) return std::get<Rendering>(std::move(outcome));
    EXPECT_EQ(failure->kind, FailureKind::unsupported);
    const std::string& reason = failure->reason;
    EXPECT_TRUE(reason.starts_with("the window-system framebuffer is not ") ||
                reason.starts_with("asked for depth24"))
        << reason;
    return std::nullopt;
  }

  // Why a scene is not drawn; empty: it is.
  std::string refusal_of(const Scene& scene) {
    const Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    return failure == nullptr ? "" : failure->reason;
  }
};

// A point that covers pixel (x, 0), `z` between -1 and 1.
inline Draw point_at(int x, double z, Color color = {1, 1, 1, 1}) {
  Draw draw = make_draw(Primitive::points, {{x * 256 + 128, 128}}, color);
  draw.vertices[0].z = Fixed::from_raw(static_cast<std::int64_t>(z * Fixed::kOne));
  return draw;
}

// Two triangles over a rectangle of whole pixels, counter-clockwise, at one depth.
inline Draw flat_rectangle(int left, int bottom, int right, int top, double z,
                           Color color = {1, 1, 1, 1}) {
  Draw draw = rectangle(left * 256, bottom * 256, right * 256, top * 256, color);
  for (Vertex& vertex : draw.vertices)
    vertex.z = Fixed::from_raw(static_cast<std::int64_t>(z * Fixed::kOne));
  return draw;
}

// The same triangles, wound the other way.
inline Draw reversed(Draw draw) {
  for (std::size_t i = 0; i + 2 < draw.vertices.size(); i += 3)
    std::swap(draw.vertices[i + 1], draw.vertices[i + 2]);
  return draw;
}

// '#' where a pixel of the lowest row has more than `least` hits, else '.'.
inline std::string hits_beyond(const Rendering& rendering, std::uint32_t least) {
  std::string text;
  for (int x = 0; x < rendering.width; ++x)
    text += rendering.hits[rendering.pixel_index(x, 0)] > least ? '#' : '.';
  return text;
}

// All that a driver tells of a scene must be the same.
inline void expect_same_rendering(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.sample_pixels, b.sample_pixels);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.depths, b.depths);
  EXPECT_EQ(a.stencils, b.stencils);
  ASSERT_EQ(a.fragments.size(), b.fragments.size());
  for (std::size_t i = 0; i < a.fragments.size(); ++i) {
    EXPECT_FALSE(precedes(a.fragments[i], b.fragments[i]) ||
                 precedes(b.fragments[i], a.fragments[i]));
    EXPECT_EQ(a.fragments[i].color, b.fragments[i].color);
    EXPECT_EQ(a.fragments[i].depth, b.fragments[i].depth);
  }
}

}  // namespace edgecase
