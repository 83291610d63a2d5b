// SPDX-License-Identifier: MIT
//
// Scene: what a case draws. Passive, complete and free of results: every default of the case file
// has been filled in, so that two renderers given the same Scene have the same task.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "exact/pixel.h"
#include "model/fragment_operations.h"
#include "model/names.h"
#include "model/sampling.h"
#include "model/texture.h"

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
template <>
inline constexpr auto kNames<Primitive> =
    std::to_array<Named<Primitive>>({{Primitive::points, "points"},
                                     {Primitive::lines, "lines"},
                                     {Primitive::line_strip, "line_strip"},
                                     {Primitive::line_loop, "line_loop"},
                                     {Primitive::triangles, "triangles"},
                                     {Primitive::triangle_strip, "triangle_strip"},
                                     {Primitive::triangle_fan, "triangle_fan"}});

// What a primitive is, once assembled.
enum class PrimitiveKind { point, line, triangle };
template <>
inline constexpr auto kNames<PrimitiveKind> =
    std::to_array<Named<PrimitiveKind>>({{PrimitiveKind::point, "point"},
                                         {PrimitiveKind::line, "line"},
                                         {PrimitiveKind::triangle, "triangle"}});

enum class Interpolation { flat, smooth, noperspective };
template <>
inline constexpr auto kNames<Interpolation> =
    std::to_array<Named<Interpolation>>({{Interpolation::flat, "flat"},
                                         {Interpolation::smooth, "smooth"},
                                         {Interpolation::noperspective, "noperspective"}});

enum class ProvokingVertex { first, last };
template <>
inline constexpr auto kNames<ProvokingVertex> = std::to_array<Named<ProvokingVertex>>(
    {{ProvokingVertex::first, "first"}, {ProvokingVertex::last, "last"}});

// Where pixels land: a framebuffer object, or the window system's framebuffer.
enum class Surface { fbo, window };
template <>
inline constexpr auto kNames<Surface> =
    std::to_array<Named<Surface>>({{Surface::fbo, "fbo"}, {Surface::window, "window"}});

enum class ColorFormat { rgba8 };
template <>
inline constexpr auto kNames<ColorFormat> = std::to_array<Named<ColorFormat>>({{ColorFormat::rgba8,
                                                                                "rgba8"}});

// Of the depth buffer; the unsigned formats hold multiples of 1/(2^bits - 1).
enum class DepthFormat { none, depth16, depth24, depth32f };
template <>
inline constexpr auto kNames<DepthFormat> =
    std::to_array<Named<DepthFormat>>({{DepthFormat::none, "none"},
                                       {DepthFormat::depth16, "depth16"},
                                       {DepthFormat::depth24, "depth24"},
                                       {DepthFormat::depth32f, "depth32f"}});

// Does the depth buffer hold float32 numbers?
constexpr bool holds_floats(DepthFormat format) {
  switch (format) {
    case DepthFormat::none:
    case DepthFormat::depth16:
    case DepthFormat::depth24:
      return false;
    case DepthFormat::depth32f:
      return true;
  }
  return false;
}

// Of the stencil buffer: unsigned integers of 8 bits.
enum class StencilFormat { none, stencil8 };
template <>
inline constexpr auto kNames<StencilFormat> = std::to_array<Named<StencilFormat>>(
    {{StencilFormat::none, "none"}, {StencilFormat::stencil8, "stencil8"}});

// Red, green, blue, alpha; linear; every component a float32 value. A target's clear colour lies in
// 0 to 1. A vertex's may be any finite number: it is what is interpolated, and only the conversion
// to the target's format clamps.
using Color = std::array<float, 4>;

// What a vertex shader hands on. With 2^e the power of two at or below the largest magnitude of the
// four, all are multiples of 2^(e-30): exact coverage then fits in 128 bits (exact/homogeneous.h).
struct ClipPosition {
  float x = 0, y = 0, z = 0, w = 1;
  friend bool operator==(const ClipPosition&, const ClipPosition&) = default;
};

// A vertex is given where it lands in the window, or as clip coordinates.
struct Vertex {
  // Window coordinates, pixels, y up; of `clip`, the nearest multiple of 2^-16, and where it lies
  // outside the clip volume, nothing: 0.
  Point position;
  Fixed z;  // depth after the division by w, -1 (near) to 1 (far); of `clip` in the same way
  Color color{1, 1, 1, 1};
  float w = 1;                                     // clip-space w; more than 0 but for `clip`
  std::array<float, 2> texture_coordinates{0, 0};  // s and t, finite; of a textured draw
  // Where set, this is what both sides are given, and the exact position is its quotient. Where
  // not, the exact position is `position`, and its clip coordinates are float32 numbers.
  std::optional<ClipPosition> clip = std::nullopt;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// Window depths of the near and of the far plane, both 0 to 1, in either order (GL 4.6
// core, 13.8.1).
struct DepthRange {
  float near = 0;
  float far = 1;
  friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

// A rectangle of window coordinates, whole pixels, y up.
struct Viewport {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const Viewport&, const Viewport&) = default;
};
constexpr PixelBounds pixels_in(const Viewport& viewport) {
  return {viewport.x, viewport.y, viewport.x + viewport.width - 1,
          viewport.y + viewport.height - 1};
}

constexpr int kMaxTargetSize = 4096;  // pixels along a side

struct Target {
  int width = 0;    // 1 to kMaxTargetSize pixels
  int height = 0;   // 1 to kMaxTargetSize pixels
  int samples = 1;  // 1: not multisampled; to kMaxSamples
  // Where the case puts a pixel's samples, `samples` of them; empty: wherever the renderer has
  // them.
  SamplePositions sample_positions;
  ColorFormat color = ColorFormat::rgba8;
  DepthFormat depth = DepthFormat::none;
  StencilFormat stencil = StencilFormat::none;
  Surface surface = Surface::fbo;
  Color clear{0, 0, 0, 1};
  float clear_depth = 1;  // 0 to 1
  std::uint8_t clear_stencil = 0;

  friend bool operator==(const Target&, const Target&) = default;
};

struct Draw {
  Primitive primitive = Primitive::triangles;
  Interpolation interpolation = Interpolation::flat;
  ProvokingVertex provoking_vertex = ProvokingVertex::last;
  Fixed line_width = Fixed::from_integer(1);  // pixels, more than 0, at most 64
  Fixed point_size = Fixed::from_integer(1);  // pixels, more than 0, at most 64
  std::optional<Viewport> scissor;            // fragments outside are dropped; a size may be 0
  Multisampling multisampling;                // of multisampled targets
  std::optional<TextureUse> texture;          // what fragments show instead of vertices' colours
  FrontFace front_face = FrontFace::ccw;
  CullMode cull = CullMode::none;               // of triangles
  std::optional<PolygonOffset> polygon_offset;  // of triangles
  // Without a depth or a stencil buffer the tests on it pass.
  FragmentOperations operations;
  std::vector<Vertex> vertices;  // as many as is_vertex_count allows

  friend bool operator==(const Draw&, const Draw&) = default;
};

// What a draw's fragments interpolate of a vertex: its colour, or for a texture s, t, 0 and 1.
Color interpolated_attribute(const Draw& draw, const Vertex& vertex);

// Is the draw rasterized sample by sample? Else the pixel's centre decides for all its samples.
inline bool is_multisampled(const Draw& draw, const Target& target) {
  return target.samples > 1 && draw.multisampling.enabled;
}

// What is told of each fragment beside its colour and its depth.
struct Details {
  bool coordinates = false;  // gl_FragCoord
  // Of the colour, or of a textured draw's texture coordinates: dFdx and dFdy, and their fine and
  // coarse forms.
  bool derivatives = false;
  // Of textured draws: texture coordinates and the level of detail. Set where there is one.
  bool texture = false;
  bool any() const { return coordinates || derivatives || texture; }
  friend bool operator==(Details, Details) = default;
};

struct Scene {
  Target target;
  Viewport viewport;
  DepthRange depth_range;
  Details details;
  // Shared by the cases that a file expands to; none is null.
  std::vector<std::shared_ptr<const Texture>> textures;
  std::vector<Draw> draws;
  // Where pixels are shaded, each time to a target of one sample; empty: once, at their centres.
  Supersampling supersampling;
};

// Do fragments meet more than being written one over the other, onto a depth buffer that was
// cleared to 1? Such a scene has no supersampling.
bool has_fragment_operations(const Scene& scene);

// Does a vertex lie in the clip volume, its border included (GL 4.6 core, 13.7)?
bool is_in_clip_volume(const ClipPosition& clip);

// The unit in which window_position counts w twice over: 2^(e-30), as ClipPosition has it.
double unit_of(const ClipPosition& clip);

// The exact window position of clip coordinates: the quotients by w, mapped onto the viewport (GL
// 4.6 core, 13.8.1). Outside the clip volume w may be 0 or less: then it is no point of the window,
// but its determinants with other points hold.
HomogeneousPoint window_position(const ClipPosition& clip, const Viewport& viewport);

PrimitiveKind kind_of(Primitive primitive);

// How many vertices a primitive of a kind has: 1, 2 or 3.
constexpr int vertices_of(PrimitiveKind kind) {
  return static_cast<int>(kind) + 1;
}

// Does this number of vertices make whole primitives, and at least one?
bool is_vertex_count(Primitive primitive, std::size_t count);

// One assembled primitive of a scene, with the index that fragments carry: primitives are numbered
// from 0 in drawing order over all draws.
struct ScenePrimitive {
  int index = 0;
  int draw = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  const Draw* state = nullptr;
  std::array<const Vertex*, 3> vertices{};  // vertices_of(kind) of them, in the order of assembly
  std::array<HomogeneousPoint, 3> positions{};  // theirs in the window, exactly
  std::array<std::int64_t, 3> z{};              // z/w, over the same w
  std::array<double, 3> units{};                // of clip coordinates: unit_of
  // A triangle some vertices of which lie outside the clip volume, or a point or line of which
  // nothing lies in it.
  bool is_clipped = false;
  // A line that leaves the clip volume: its positions are the ends of what lies in it.
  bool is_cut = false;
  DepthRange depth_range;  // of their depths in the window
  Viewport viewport;       // that they are seen through
  // Which of them provokes under either convention (GL 4.6 core, table 13.2).
  int provoking_first = 0;
  int provoking_last = 0;
};

// Are its vertices given as clip coordinates, some of them or all?
bool has_clip_positions(const ScenePrimitive& primitive);

// Do its vertices differ in w? Then smooth and noperspective attributes differ.
bool has_perspective(const ScenePrimitive& primitive);

// All primitives of a scene in drawing order. The pointers live as long as `scene` does.
std::vector<ScenePrimitive> primitives_of(const Scene& scene);

}  // namespace edgecase
