// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/scenes.h"

#include <memory>
#include <utility>

namespace edgecase {

namespace {

constexpr int kSize = 16;
constexpr Color kWhite = {1, 1, 1, 1};
constexpr Color kRed = {1, 0, 0, 1};
constexpr Color kGreen = {0, 1, 0, 1};
constexpr Color kBlue = {0, 0, 1, 1};

Vertex at(int x, int y, Color color = kWhite) {
  Vertex vertex;
  vertex.position = {Fixed::from_integer(x), Fixed::from_integer(y)};
  vertex.color = color;
  return vertex;
}

Scene black_scene() {
  Scene scene = empty_scene(kSize, kSize);
  scene.target.clear = {0, 0, 0, 1};
  return scene;
}

// The lower left half of the target; pixel (4, 4) lies deep inside.
Draw half_of_it(Color color) {
  Draw draw;
  draw.vertices = {at(0, 0, color), at(kSize, 0, color), at(0, kSize, color)};
  return draw;
}

Scene with(std::vector<Draw> draws) {
  Scene scene = black_scene();
  scene.draws = std::move(draws);
  return scene;
}

// Two draws of the same half: a red one, and then a green one, which must not show.
Scene red_scene() {
  return with({half_of_it(kRed), half_of_it(kGreen)});
}

// The red one is nearer.
Scene depth_scene() {
  Scene scene = red_scene();
  scene.target.depth = DepthFormat::depth24;
  for (Draw& draw : scene.draws) draw.operations.depth.function = CompareFunction::less;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.z = Fixed::from_raw(-Fixed::kOne / 2);
  return scene;
}

Scene stencil_scene() {
  Scene scene = red_scene();
  scene.target.stencil = StencilFormat::stencil8;
  StencilFace never;
  never.function = CompareFunction::never;
  scene.draws[1].operations.stencil = StencilTest{never, never};
  return scene;
}

Scene samples_scene(int samples) {
  Scene scene = with({half_of_it(kRed)});
  scene.target.samples = samples;
  scene.draws[0].multisampling.mask = (1U << static_cast<unsigned>(samples)) - 1;
  return scene;
}

// White vertices; the one texel is blue.
Scene texture_scene() {
  Scene scene = with({half_of_it(kWhite)});
  Texture texture;
  texture.levels = {TextureLevel{1, 1, {0, 0, 255, 255}}};
  scene.textures = {std::make_shared<const Texture>(std::move(texture))};
  TextureUse use;
  use.sampler.magnify = Filter::nearest;
  scene.draws[0].texture = use;
  scene.draws[0].interpolation = Interpolation::smooth;
  return scene;
}

Scene blending_scene() {
  Scene scene = red_scene();
  const BlendTerm keep = {BlendEquation::add, BlendFactor::zero, BlendFactor::one};
  scene.draws[1].operations.blending = Blending{keep, keep};
  return scene;
}

Scene supersampled_scene() {
  Scene scene = with({half_of_it(kRed)});
  const Fixed quarter = Fixed::from_raw(Fixed::kOne / 4);
  const Fixed rest = Fixed::from_integer(1) - quarter;
  scene.supersampling = {{{quarter, quarter}, 1}, {{rest, rest}, 3}};
  return scene;
}

Scene scissored_scene() {
  Scene scene = red_scene();
  scene.draws[1].scissor = Viewport{8, 0, 8, kSize};
  return scene;
}

Scene culled_scene() {
  Scene scene = red_scene();
  scene.draws[1].cull = CullMode::front;
  return scene;
}

Scene masked_scene() {
  Scene scene = red_scene();
  scene.draws[1].operations.color_mask = {false, false, false, false};
  return scene;
}

// Through the middle, (2, 8) to (14, 8) or (8, 8), and 8 pixels wide.
Scene thick_scene(Primitive primitive) {
  Draw draw;
  draw.primitive = primitive;
  draw.line_width = draw.point_size = Fixed::from_integer(8);
  draw.vertices = {at(8, 8, kRed)};
  if (primitive == Primitive::lines) draw.vertices = {at(2, 8, kRed), at(14, 8, kRed)};
  return with({draw});
}

// Red at the corner, blue at the others.
Scene blended_colors(Interpolation interpolation, float w) {
  Scene scene = with({half_of_it(kBlue)});
  scene.draws[0].interpolation = interpolation;
  scene.draws[0].vertices[0].color = kRed;
  scene.draws[0].vertices[0].w = w;
  return scene;
}

// A triangle round the whole clip volume; its second and third vertices are no points of the
// window.
Scene clipped_scene() {
  Scene scene = with({half_of_it(kRed)});
  auto& vertices = scene.draws[0].vertices;
  vertices[0].clip = ClipPosition{-1, -1, 0, 1};
  vertices[1].clip = ClipPosition{3, -1, 0, 1};
  vertices[2].clip = ClipPosition{-1, 3, 0, 1};
  for (std::size_t i = 1; i < 3; ++i) vertices[i].position = {};
  return scene;
}

Scene detailed_scene() {
  Scene scene = with({half_of_it(kRed)});
  scene.details.coordinates = scene.details.derivatives = true;
  return scene;
}

Scene window_scene() {
  Scene scene = with({half_of_it(kRed)});
  scene.target.surface = Surface::window;
  return scene;
}

}  // namespace

Scene empty_scene(int width, int height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.target.clear = kRed;
  scene.viewport = {0, 0, width, height};
  return scene;
}

Scene scene_of(Primitive primitive) {
  Draw draw;
  draw.primitive = primitive;
  draw.point_size = Fixed::from_integer(1);
  // Vertices around the target's middle, in an order that also suits strips and fans.
  const int corners[][2] = {{2, 3}, {13, 2}, {3, 13}, {14, 14}, {7, 15}, {1, 9}};
  int count = 4;
  if (kind_of(primitive) == PrimitiveKind::triangle && primitive != Primitive::triangle_strip &&
      primitive != Primitive::triangle_fan)
    count = 6;
  for (int i = 0; i < count; ++i) {
    // Off the pixels' boundaries, where a point could belong to either side.
    Vertex vertex = at(corners[i][0], corners[i][1]);
    const Fixed off = Fixed::from_raw(Fixed::kOne * 3 / 8);
    vertex.position = {vertex.position.x + off, vertex.position.y + off};
    draw.vertices.push_back(vertex);
  }
  return with({draw});
}

Scene scene_without_extent() {
  std::vector<Draw> draws;
  for (const Primitive primitive : {Primitive::points, Primitive::lines, Primitive::line_loop,
                                    Primitive::triangles, Primitive::triangle_fan}) {
    Draw draw;
    draw.primitive = primitive;
    const Color far = {-1e30F, 1e30F, 1e-30F, 0};
    draw.vertices = {at(3, 3, far), at(3, 3), at(3, 3, far), at(3, 3), at(9, 9, far), at(15, 15)};
    draws.push_back(draw);
  }
  return with(draws);
}

std::vector<FeatureScene> feature_scenes() {
  std::vector<FeatureScene> all = {
      {"colours that vary",
       blended_colors(Interpolation::noperspective, 1),
       4,
       4,
       {112, 0, 143},
       24},
      {"perspective", blended_colors(Interpolation::smooth, 0.125F), 4, 4, {220, 0, 35}, 24},
      {"vertices outside the clip volume", clipped_scene(), 12, 12, {255, 0, 0}},
      {"wide lines", thick_scene(Primitive::lines), 8, 10, {255, 0, 0}},
      {"large points", thick_scene(Primitive::points), 10, 10, {255, 0, 0}},
      {"a scissor", scissored_scene(), 4, 4, {255, 0, 0}},
      {"a depth buffer", depth_scene(), 4, 4, {255, 0, 0}, 0, "depth"},
      {"a stencil buffer", stencil_scene(), 4, 4, {255, 0, 0}, 0, "stencil"},
      {"blending", blending_scene(), 4, 4, {255, 0, 0}},
      {"a colour mask", masked_scene(), 4, 4, {255, 0, 0}},
      {"culling", culled_scene(), 4, 4, {255, 0, 0}},
      {"several samples", samples_scene(4), 4, 4, {255, 0, 0}},
      {"textures", texture_scene(), 4, 4, {0, 0, 255}},
      {"supersampling", supersampled_scene(), 4, 4, {255, 0, 0}},
      {"details", detailed_scene(), 4, 4, {255, 0, 0}},
      {"window surfaces", window_scene(), 4, 4, {255, 0, 0}},
  };
  return all;
}

}  // namespace edgecase
