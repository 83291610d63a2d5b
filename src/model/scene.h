// SPDX-License-Identifier: MIT
//
// Scene: what a case draws. Passive, complete and free of results: every default of the case file
// has been filled in, so that two renderers given the same Scene have the same task.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

enum class Primitive { points, lines, triangles };
enum class Interpolation { flat, smooth };
enum class ProvokingVertex { first, last };
// Where pixels land: a framebuffer object, or the window system's framebuffer.
enum class Surface { fbo };
enum class ColorFormat { rgba8 };

// Red, green, blue, alpha; linear, 0 to 1; every component a float32 value.
using Color = std::array<float, 4>;

struct Vertex {
  Point position;  // window coordinates, pixels, y up
  Fixed z;         // clip-space depth, -1 (near) to 1 (far); w is 1
  Color color{1, 1, 1, 1};
};

// A rectangle of window coordinates, whole pixels, y up.
struct Viewport {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

struct Target {
  int width = 0;   // 1 to 4096 pixels
  int height = 0;  // 1 to 4096 pixels
  int samples = 1;
  ColorFormat color = ColorFormat::rgba8;
  Surface surface = Surface::fbo;
  Color clear{0, 0, 0, 1};
};

struct Draw {
  Primitive primitive = Primitive::triangles;
  Interpolation interpolation = Interpolation::flat;
  ProvokingVertex provoking_vertex = ProvokingVertex::last;
  std::vector<Vertex> vertices;  // a multiple of vertices_per_primitive(primitive)
};

struct Scene {
  Target target;
  Viewport viewport;
  std::vector<Draw> draws;
};

constexpr int vertices_per_primitive(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return 1;
    case Primitive::lines:
      return 2;
    case Primitive::triangles:
      return 3;
  }
  return 1;
}

// The names that case files, JSON and reports use.
const char* name_of(Primitive);
const char* name_of(Interpolation);
const char* name_of(ProvokingVertex);
const char* name_of(Surface);
const char* name_of(ColorFormat);

// The inverse: false when `name` names none, `value` then untouched.
bool parse_name(const std::string& name, Primitive& value);
bool parse_name(const std::string& name, Interpolation& value);
bool parse_name(const std::string& name, ProvokingVertex& value);
bool parse_name(const std::string& name, Surface& value);
bool parse_name(const std::string& name, ColorFormat& value);

// One primitive of a scene, with the index that fragments carry: primitives are numbered from 0 in
// drawing order over all draws.
struct ScenePrimitive {
  int index = 0;
  int draw = 0;
  const Draw* state = nullptr;
  const Vertex* vertices = nullptr;  // vertices_per_primitive(state->primitive) of them
};

// All primitives of a scene in drawing order. The pointers live as long as `scene` does.
std::vector<ScenePrimitive> primitives_of(const Scene& scene);

}  // namespace edgecase
