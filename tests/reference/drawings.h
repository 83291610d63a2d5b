// SPDX-License-Identifier: MIT
//
// Scenes and their coverage as text, for the tests of the OpenGL side and of the example.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "processes/process_renderer.h"

namespace edgecase {

inline Scene blank_scene(int width, int height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.viewport = {0, 0, width, height};
  return scene;
}

// Positions are in 1/256 of a pixel, so that a test can write 1 * 256 + 64.
inline Draw make_draw(Primitive primitive, const std::vector<std::pair<int, int>>& positions,
                      Color color = {1, 1, 1, 1}) {
  Draw draw;
  draw.primitive = primitive;
  for (const auto& [x, y] : positions) {
    Vertex vertex;
    vertex.position = {Fixed::from_raw(x * (Fixed::kOne / 256)),
                       Fixed::from_raw(y * (Fixed::kOne / 256))};
    vertex.color = color;
    draw.vertices.push_back(vertex);
  }
  return draw;
}

// An axis-aligned rectangle of two triangles that share the diagonal from the lower left corner.
inline Draw rectangle(int left, int bottom, int right, int top, Color color = {1, 1, 1, 1}) {
  return make_draw(
      Primitive::triangles,
      {{left, bottom}, {right, bottom}, {right, top}, {left, bottom}, {right, top}, {left, top}},
      color);
}

inline Outcome render_outcome(Renderer& renderer, const Scene& scene) {
  const Task task{"test", &scene};
  Outcome result = Failure{FailureKind::crashed, "no outcome came"};
  renderer.render({&task, 1}, [&](std::size_t, Outcome outcome) { result = std::move(outcome); });
  return result;
}

// The rendering, or an empty one and a failed test.
inline Rendering render(Renderer& renderer, const Scene& scene) {
  Outcome outcome = render_outcome(renderer, scene);
  if (const auto* failure = std::get_if<Failure>(&outcome)) {
    ADD_FAILURE() << name_of(failure->kind) << ": " << failure->reason;
    return {};
  }
  return std::move(std::get<Rendering>(outcome));
}

// Fragments per pixel, top row first: '.', '#' for one, digits for more; rows end with a '\n'.
inline std::string coverage(const Rendering& rendering) {
  std::vector<int> counts(rendering.pixels.size() / 4);
  for (const Fragment& fragment : rendering.fragments)
    ++counts[rendering.pixel_index(fragment.x, fragment.y)];
  std::string text;
  for (int y = rendering.height - 1; y >= 0; --y) {
    for (int x = 0; x < rendering.width; ++x)
      text += ".#23456789"[counts[rendering.pixel_index(x, y)]];
    text += '\n';
  }
  return text;
}

inline std::vector<int> pixel(const Rendering& rendering, int x, int y) {
  if (rendering.pixels.empty()) return {};
  const auto* first = rendering.pixels.data() + 4 * rendering.pixel_index(x, y);
  return {first, first + 4};
}

}  // namespace edgecase
