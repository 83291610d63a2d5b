// SPDX-License-Identifier: MIT
//
// Scene: what a case draws. Passive, complete and free of results: all defaults of the case file
// are filled in, so that renderers given equal scenes have equal tasks.
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

// The kind of an assembled primitive.
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

// The depth buffer's format; the unsigned formats hold multiples of 1/(2^bits - 1).
enum class DepthFormat { none, depth16, depth24, depth32f };
template <>
inline constexpr auto kNames<DepthFormat> =
    std::to_array<Named<DepthFormat>>({{DepthFormat::none, "none"},
                                       {DepthFormat::depth16, "depth16"},
                                       {DepthFormat::depth24, "depth24"},
                                       {DepthFormat::depth32f, "depth32f"}});

// Whether the depth buffer stores float32 numbers.
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

// The stencil buffer's format: unsigned integers of 8 bits.
enum class StencilFormat { none, stencil8 };
template <>
inline constexpr auto kNames<StencilFormat> = std::to_array<Named<StencilFormat>>(
    {{StencilFormat::none, "none"}, {StencilFormat::stencil8, "stencil8"}});

// Red, green, blue, alpha; linear; every component a float32 value. A target's clear colour lies in
// 0 to 1. A vertex's may be any finite number: only the conversion of the interpolated colour to
// the target's format clamps.
using Color = std::array<float, 4>;

// The output of a vertex shader. With 2^e the power of two at or below the largest magnitude, all
// are multiples of 2^(e-30): exact coverage then fits in 128 bits (exact/homogeneous.h).
struct ClipPosition {
  float x = 0, y = 0, z = 0, w = 1;
  friend bool operator==(const ClipPosition&, const ClipPosition&) = default;
};

// A vertex is given in window coordinates or in clip coordinates.
struct Vertex {
  // Window coordinates, pixels, y up. With `clip`, the nearest multiple of 2^-16, or 0 if the
  // vertex lies outside the clip volume.
  Point position;
  Fixed z;  // depth after the division by w, -1 (near) to 1 (far); with `clip` likewise derived
  Color color{1, 1, 1, 1};
  float w = 1;                                     // clip-space w; above 0 unless `clip` is set
  std::array<float, 2> texture_coordinates{0, 0};  // s and t, finite; for a textured draw
  // If set, both sides are given this, and the exact position is its quotient. If not, the exact
  // position is `position`, and its clip coordinates are float32 numbers.
  std::optional<ClipPosition> clip = std::nullopt;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// Window depths of the near and the far plane, both 0 to 1, in either order (GL 4.6 core, 13.8.1).
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
  int samples = 1;  // 1 to kMaxSamples; 1: not multisampled
  // The case's sample positions, `samples` of them; empty if the renderer chooses them.
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
  std::optional<Viewport> scissor;            // fragments outside are discarded; a size may be 0
  Multisampling multisampling;                // for multisampled targets
  std::optional<TextureUse> texture;          // replaces the vertices' colours
  FrontFace front_face = FrontFace::ccw;
  CullMode cull = CullMode::none;               // for triangles
  std::optional<PolygonOffset> polygon_offset;  // for triangles
  // Tests on an absent depth or stencil buffer pass.
  FragmentOperations operations;
  std::vector<Vertex> vertices;  // a number that is_vertex_count allows

  friend bool operator==(const Draw&, const Draw&) = default;
};

// The vertex attribute that fragments interpolate: the colour or, in a textured draw, (s, t, 0, 1).
Color interpolated_attribute(const Draw& draw, const Vertex& vertex);

// Whether samples are rasterized individually; otherwise the pixel's centre decides for all.
inline bool is_multisampled(const Draw& draw, const Target& target) {
  return target.samples > 1 && draw.multisampling.enabled;
}

// Which further values of each fragment are requested, beside colour and depth.
struct Details {
  bool coordinates = false;  // gl_FragCoord
  // Of the colour, or of a textured draw's texture coordinates: dFdx and dFdy, and their fine and
  // coarse forms.
  bool derivatives = false;
  // For textured draws: texture coordinates and level of detail. Set if there is such a draw.
  bool texture = false;
  bool any() const { return *this != Details{}; }
  friend bool operator==(Details, Details) = default;
};

struct Scene {
  Target target;
  Viewport viewport;
  DepthRange depth_range;
  Details details;
  // Shared by the cases that a file expands to; never null.
  std::vector<std::shared_ptr<const Texture>> textures;
  std::vector<Draw> draws;
  // The shaded points, each with a pass to a target of one sample; empty: once, at pixels' centres.
  Supersampling supersampling;
  // Whether the sides of the view volume clip points and lines, as OpenGL has it. No key of a case:
  // the API of who draws it decides (model/side_clipping.h).
  bool clips_sides = true;
};

// Whether there are fragment operations beyond overwriting colours and a depth buffer cleared to 1.
// Such a scene cannot be supersampled.
bool has_fragment_operations(const Scene& scene);

// Whether a vertex lies in the clip volume, including its border (GL 4.6 core, 13.7).
bool is_in_clip_volume(const ClipPosition& clip);

// Whether it lies between the near and the far plane, in front of the eye.
bool is_between_near_and_far(const ClipPosition& clip);

// The unit 2^(e-30) of ClipPosition; window_position has twice the clip w in this unit.
double unit_of(const ClipPosition& clip);

// The exact window position of clip coordinates: the quotients by w, mapped onto the viewport (GL
// 4.6 core, 13.8.1). Outside the clip volume w may be 0 or less: the result is then no point of the
// window, but its determinants with other points are valid.
HomogeneousPoint window_position(const ClipPosition& clip, const Viewport& viewport);

PrimitiveKind kind_of(Primitive primitive);

// The number of vertices of a primitive: 1, 2 or 3.
constexpr int vertices_of(PrimitiveKind kind) {
  return static_cast<int>(kind) + 1;
}

// Whether this number of vertices makes whole primitives, at least one.
bool is_vertex_count(Primitive primitive, std::size_t count);

// One assembled primitive of a scene, with the index that fragments carry: primitives are numbered
// from 0 in drawing order over all draws.
struct ScenePrimitive {
  int index = 0;
  int draw = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  const Draw* state = nullptr;
  std::array<const Vertex*, 3> vertices{};  // vertices_of(kind) of them, in the order of assembly
  std::array<HomogeneousPoint, 3> positions{};  // their exact window positions
  std::array<std::int64_t, 3> z{};              // z/w, over the same w
  std::array<double, 3> units{};                // for clip coordinates: unit_of
  // A triangle with vertices outside the clip volume, or a point or line entirely outside it.
  bool is_clipped = false;
  // A line that leaves the clip volume: its positions are the ends of the part inside.
  bool is_cut = false;
  bool clips_sides = true;  // of the scene: the planes that clip this point or line
  DepthRange depth_range;   // of the scene
  Viewport viewport;        // of the scene
  // Which vertex provokes under either convention (GL 4.6 core, table 13.2).
  int provoking_first = 0;
  int provoking_last = 0;
};

// Whether any vertex is given in clip coordinates.
bool has_clip_positions(const ScenePrimitive& primitive);

// Whether the vertices differ in w, so that smooth and noperspective attributes differ.
bool has_perspective(const ScenePrimitive& primitive);

// The same point or line, clipped at the sides or not.
ScenePrimitive with_sides(ScenePrimitive primitive, bool clips_sides);

// All primitives of a scene in drawing order. The pointers live as long as `scene` does.
std::vector<ScenePrimitive> primitives_of(const Scene& scene);

// A scene in one line of text, for tables and summaries: what is drawn on what. Colours, depths and
// the viewport are left out, so different scenes may have the same text.

// "line (1/2, 1/2) to (7/2, 1/2), 4x4, window": each draw, joined by "; ", then the target's width
// and height in pixels, and "window" if it is no framebuffer object. Coordinates in pixels, y up.
// State is named if it is not the default: "width 3/2", "smooth". For many vertices, only the first
// ones and the number of others are listed.
std::string scene_text(const Scene& scene);

// Whether both are equal in every part, so that every renderer has the same task.
bool same_scene(const Scene& a, const Scene& b);

}  // namespace edgecase
