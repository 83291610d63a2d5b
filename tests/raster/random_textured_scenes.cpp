// SPDX-License-Identifier: MIT
#include "tests/raster/random_textured_scenes.h"

#include <algorithm>

#include "tests/raster/random_scenes.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                           Wrap::clamp_to_border};
constexpr TextureFormat kFormats[] = {TextureFormat::rgba8, TextureFormat::srgb8,
                                      TextureFormat::rgba32f};

}  // namespace

Texture TexturedScenes::texture() {
  const TextureFormat format = kFormats[numbers_.integer(0, 2)];
  const bool flat = numbers_.one_in(6);
  const bool whole = numbers_.one_in(4);  // powers of two
  const auto size = [&] {
    return static_cast<int>(whole ? 1 << numbers_.integer(0, 3) : numbers_.integer(1, 9));
  };
  width_ = size();
  height_ = flat ? 1 : size();
  const TexelOf texels = random_texels(numbers_, format);
  Texture texture = numbers_.one_in(6) ? single_of(width_, height_, format, texels)
                                       : chain_of(width_, height_, format, texels);
  if (flat) texture.dimensions = 1;
  return texture;
}

Scene TexturedScenes::next() {
  on_grid_ = numbers_.one_in(2);
  Scene scene = blank_scene(8, 8);
  scene.textures = {std::make_shared<const Texture>(texture())};
  scene.draws = {draw(sampler(static_cast<int>(scene.textures[0]->levels.size())))};
  return scene;
}

Sampler TexturedScenes::sampler(int levels) {
  Sampler s;
  s.wrap = {kWraps[numbers_.integer(0, 3)], kWraps[numbers_.integer(0, 3)]};
  s.magnify = numbers_.one_in(2) ? Filter::nearest : Filter::linear;
  s.minify = numbers_.one_in(2) ? Filter::nearest : Filter::linear;
  s.mipmap = levels == 1 ? MipFilter::none : static_cast<MipFilter>(numbers_.integer(0, 2));
  s.base_level = numbers_.one_in(3) ? static_cast<int>(numbers_.integer(0, levels - 1)) : 0;
  if (numbers_.one_in(4)) s.max_level = s.base_level + static_cast<int>(numbers_.integer(0, 2));
  if (numbers_.one_in(2)) s.lod_bias = number(0.5, 4);
  if (numbers_.one_in(4)) s.min_lod = on(0.5, 2);
  if (numbers_.one_in(4)) s.max_lod = s.min_lod + 1500 + on(0.25, 4);
  if (numbers_.one_in(8)) s.max_lod = std::max(s.min_lod, on(0.25, 8));
  for (float& component : s.border) component = on(0.25, 6);
  return s;
}

Vertex TexturedScenes::vertex(bool perspective) {
  Vertex v;
  v.position = on_grid_ ? at(static_cast<double>(numbers_.integer(-4, 24)) / 2,
                             static_cast<double>(numbers_.integer(-4, 24)) / 2)
                        : numbers_.point(12 * Fixed::kOne);
  v.texture_coordinates = {number(0.25, 8), number(0.25, 8)};
  if (perspective)
    v.w = on_grid_ ? static_cast<float>(numbers_.integer(1, 4))
                   : static_cast<float>(numbers_.clip_w(2));
  return v;
}

// Sides along the axes, and a texture that is shown so many texels a pixel.
void TexturedScenes::straighten(Draw& draw) {
  const double size = static_cast<double>(numbers_.integer(1, 8));
  const auto scale = static_cast<double>(numbers_.integer(1, 8)) * size / 2;
  for (std::size_t v = 0; v < draw.vertices.size(); ++v) {
    draw.vertices[v].position = at(v == 1 ? size : 0, v == 2 ? size : 0);
    draw.vertices[v].texture_coordinates = {static_cast<float>((v == 1 ? scale : 0) / width_),
                                            static_cast<float>((v == 2 ? scale : 0) / height_)};
  }
}

Draw TexturedScenes::draw(const Sampler& sampler) {
  Draw draw;
  const PrimitiveKind kind = numbers_.one_in(4)   ? PrimitiveKind::line
                             : numbers_.one_in(8) ? PrimitiveKind::point
                                                  : PrimitiveKind::triangle;
  draw.primitive = kind == PrimitiveKind::line    ? Primitive::lines
                   : kind == PrimitiveKind::point ? Primitive::points
                                                  : Primitive::triangles;
  draw.interpolation = static_cast<Interpolation>(numbers_.integer(0, 2));
  const bool perspective = numbers_.one_in(2);
  for (int v = 0; v < vertices_of(kind); ++v) draw.vertices.push_back(vertex(perspective));
  if (on_grid_ && !perspective && numbers_.one_in(2)) straighten(draw);
  Lookup lookup;
  lookup.kind = static_cast<LookupKind>(numbers_.integer(0, 3));
  lookup.value = number(0.5, 6);
  for (auto* d : {&lookup.dx, &lookup.dy}) *d = {number(0.125, 8), number(0.125, 8)};
  draw.texture = TextureUse{0, sampler, lookup};
  return draw;
}

float TexturedScenes::on(double step, std::int64_t limit) {
  return static_cast<float>(step * static_cast<double>(numbers_.integer(-limit, limit)));
}

float TexturedScenes::number(double step, std::int64_t limit) {
  return on_grid_ ? on(step, limit)
                  : static_cast<float>(numbers_.attribute(step * static_cast<double>(limit)));
}

}  // namespace edgecase
