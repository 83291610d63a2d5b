// SPDX-License-Identifier: MIT
//
// Scenes for the tests of src/wire, and what changes their lines.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "model/scene.h"
#include "wire/request_line.h"

namespace edgecase {

// The text with `to` in place of the first `from`, which must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// What a parser says against a text; empty: nothing.
template <class Parsed>
std::string fault_in(const Parsed& parsed) {
  const auto* error = std::get_if<WireError>(&parsed);
  return error == nullptr ? "" : error->message;
}

// A 3x2 target with one triangle and one line: primitives 0 and 1.
inline Scene small_scene() {
  Scene scene;
  scene.target.width = 3;
  scene.target.height = 2;
  scene.target.clear = {0, 0.25f, 0.1f, 1};
  scene.viewport = {-1, -2, 8, 16};
  const auto vertex = [](std::int64_t raw_x, std::int64_t raw_y, Color color) {
    Vertex result;
    result.position = {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
    result.z = Fixed::from_raw(raw_x / 7);
    result.color = color;
    return result;
  };
  Draw triangle;
  triangle.interpolation = Interpolation::smooth;
  triangle.provoking_vertex = ProvokingVertex::first;
  triangle.vertices = {vertex(1, -1, {1, 0, 0, 1}), vertex(200001, 65535, {0, 0.3f, 0, 1}),
                       vertex(0, 131072, {0, 0, 1e-7f, 0.5f})};
  Draw line;
  line.primitive = Primitive::lines;
  line.line_width = Fixed::from_raw(5 * Fixed::kOne / 2);
  line.point_size = Fixed::from_raw(1);
  line.scissor = Viewport{-1, 0, 3, 0};
  line.vertices = {vertex(-32768, 32768, {1, 1, 1, 1}), vertex(163840, 98304, {1, 1, 1, 1})};
  scene.draws = {triangle, line};
  return scene;
}

// Texels that differ: codes, or of rgba32f numbers that are none.
inline TextureLevel texture_level(int width, int height, TextureFormat format) {
  TextureLevel level;
  level.width = width;
  level.height = height;
  for (std::size_t i = 0; i < level.index(0, height); ++i) {
    const auto value = static_cast<float>(i * 37 % 256);
    level.texels.push_back(format == TextureFormat::rgba32f ? value / 3 - 7 : value);
  }
  return level;
}

// One level, or a whole chain.
inline Texture make_texture(int width, int height, TextureFormat format, bool whole = false) {
  Texture texture;
  texture.dimensions = height == 1 ? 1 : 2;
  texture.format = format;
  for (int level = 0; level < (whole ? level_count(width, height) : 1); ++level)
    texture.levels.push_back(
        texture_level(level_size(width, level), level_size(height, level), format));
  return texture;
}

// small_scene with three textures, a whole chain of 5x3, a single level of 4x1 and generated ones
// of 2x2: the triangle looks up the first, the line nothing.
inline Scene textured_scene() {
  Scene scene = small_scene();
  scene.details.texture = true;
  Texture generated = make_texture(2, 2, TextureFormat::srgb8);
  generated.generated = true;
  scene.textures = {std::make_shared<const Texture>(make_texture(5, 3, TextureFormat::rgba8, true)),
                    std::make_shared<const Texture>(make_texture(4, 1, TextureFormat::rgba32f)),
                    std::make_shared<const Texture>(generated)};
  Draw& draw = scene.draws[0];
  draw.texture = TextureUse();
  draw.vertices[0].texture_coordinates = {-0.5f, 0.1f};
  draw.vertices[1].texture_coordinates = {1e-30f, 1e30f};
  draw.vertices[2].texture_coordinates = {3, -0.0f};
  return scene;
}

}  // namespace edgecase
