// SPDX-License-Identifier: MIT
//
// Scene: what a case draws. Passive, complete and free of results: every default of the case file
// has been filled in, so that two renderers given the same Scene have the same task.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

// How a draw's vertices make primitives (GL 4.6 core, 10.1).
enum class Primitive {
  points,
  lines,
  line_strip,
  line_loop,
  triangles,
  triangle_strip,
  triangle_fan,
};
// What a primitive is, once assembled.
enum class PrimitiveKind { point, line, triangle };
enum class Interpolation { flat, smooth, noperspective };
enum class ProvokingVertex { first, last };
// Where pixels land: a framebuffer object, or the window system's framebuffer.
enum class Surface { fbo, window };
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
  Fixed line_width = Fixed::from_integer(1);  // pixels, more than 0, at most 64
  Fixed point_size = Fixed::from_integer(1);  // pixels, more than 0, at most 64
  std::optional<Viewport> scissor;            // fragments outside are dropped; a size may be 0
  std::vector<Vertex> vertices;               // as many as is_vertex_count allows
};

struct Scene {
  Target target;
  Viewport viewport;
  std::vector<Draw> draws;
};

PrimitiveKind kind_of(Primitive primitive);

// How many vertices a primitive of a kind has: 1, 2 or 3.
constexpr int vertices_of(PrimitiveKind kind) {
  return static_cast<int>(kind) + 1;
}

// Does this number of vertices make whole primitives, and at least one?
bool is_vertex_count(Primitive primitive, std::size_t count);

// The names that case files, JSON and reports use.
const char* name_of(Primitive);
const char* name_of(PrimitiveKind);
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

// One assembled primitive of a scene, with the index that fragments carry: primitives are numbered
// from 0 in drawing order over all draws.
struct ScenePrimitive {
  int index = 0;
  int draw = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  const Draw* state = nullptr;
  std::array<const Vertex*, 3> vertices{};  // vertices_of(kind) of them, in the order of assembly
  // Which of them provokes under either convention (GL 4.6 core, table 13.2).
  int provoking_first = 0;
  int provoking_last = 0;
};

// All primitives of a scene in drawing order. The pointers live as long as `scene` does.
std::vector<ScenePrimitive> primitives_of(const Scene& scene);

}  // namespace edgecase
