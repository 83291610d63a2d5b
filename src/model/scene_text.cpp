// SPDX-License-Identifier: MIT
#include "model/scene_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

#include "exact/numeral.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostPrimitives = 3;  // listed one by one
constexpr std::size_t kMostVertices = 6;    // listed of a strip, loop or fan

// The shortest decimal that reads back as the same float32 number.
std::string decimal_of(float value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string text_of(Point point) {
  return "(" + to_fraction(point.x) + ", " + to_fraction(point.y) + ")";
}

// The vertices from `from` up to `to`, exclusive.
std::string list_vertices(const Draw& draw, std::size_t from, std::size_t to,
                          std::string_view separator) {
  std::string text;
  for (std::size_t i = from; i < to; ++i) {
    if (i != from) text += separator;
    text += text_of(draw.vertices[i].position);
    if (draw.vertices[i].w != 1) text += " w " + decimal_of(draw.vertices[i].w);
  }
  return text;
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Separate primitives: "line A to B and line C to D", or the first of many.
std::string separate_text(const Draw& draw) {
  const PrimitiveKind kind = kind_of(draw.primitive);
  const auto each = static_cast<std::size_t>(vertices_of(kind));
  const std::size_t count = draw.vertices.size() / each;
  const std::size_t shown = count <= kMostPrimitives ? count : 1;
  const std::string_view separator = kind == PrimitiveKind::line ? " to " : ", ";
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i != 0) text += " and ";
    text += std::string(name_of(kind)) + " ";
    text += list_vertices(draw, i * each, (i + 1) * each, separator);
  }
  if (shown == count) return text;
  return std::to_string(count) + " " + name_of(draw.primitive) + ", the first " + text;
}

std::string connected_text(const Draw& draw) {
  const std::size_t count = draw.vertices.size();
  const std::size_t shown = std::min(count, kMostVertices);
  std::string text = spaced(name_of(draw.primitive)) + " " + list_vertices(draw, 0, shown, ", ");
  if (shown != count) text += " and " + std::to_string(count - shown) + " more";
  return text;
}

std::string texture_text(const TextureUse& use) {
  const Sampler& sampler = use.sampler;
  std::string text = std::string(" ") + name_of(sampler.wrap[0]) + " " + name_of(sampler.wrap[1]) +
                     ", magnified " + name_of(sampler.magnify) + ", minified " +
                     name_of(sampler.minify) + ", levels " + name_of(sampler.mipmap);
  if (use.lookup.kind != LookupKind::implicit) text += std::string(", ") + name_of(use.lookup.kind);
  return text;
}

std::string mask_text(const std::array<bool, 4>& mask) {
  std::string text = ", mask ";
  for (std::size_t i = 0; i < mask.size(); ++i) text += mask[i] ? "rgba"[i] : '-';
  return text;
}

std::string operation_text(const Draw& draw) {
  const FragmentOperations& own = draw.operations;
  const FragmentOperations standard;
  std::string text;
  if (draw.front_face != FrontFace::ccw)
    text += ", front faces " + std::string(name_of(draw.front_face));
  if (draw.cull != CullMode::none) text += ", culled " + spaced(name_of(draw.cull));
  if (draw.polygon_offset) text += ", offset";
  if (own.stencil) text += ", stencil test";
  if (own.depth.function != standard.depth.function)
    text += std::string(", depth ") + name_of(own.depth.function);
  if (!own.depth.write) text += ", depth not written";
  if (own.blending) text += ", blended";
  if (own.color_mask != standard.color_mask) text += mask_text(own.color_mask);
  return text;
}

std::string state_text(const Draw& draw) {
  const Fixed one = Fixed::from_integer(1);
  const Draw standard;
  std::string text;
  if (draw.line_width != one) text += ", width " + to_fraction(draw.line_width);
  if (draw.point_size != one) text += ", size " + to_fraction(draw.point_size);
  if (draw.interpolation != standard.interpolation)
    text += std::string(", ") + name_of(draw.interpolation);
  if (draw.provoking_vertex != standard.provoking_vertex)
    text += std::string(", ") + name_of(draw.provoking_vertex) + " vertex provokes";
  if (draw.texture)
    text += ", texture " + std::to_string(draw.texture->texture) + texture_text(*draw.texture);
  if (draw.scissor)
    text += ", scissor " + std::to_string(draw.scissor->width) + "x" +
            std::to_string(draw.scissor->height) + " at (" + std::to_string(draw.scissor->x) +
            ", " + std::to_string(draw.scissor->y) + ")";
  return text + operation_text(draw);
}

std::string draw_text(const Draw& draw) {
  const auto each = static_cast<std::size_t>(vertices_of(kind_of(draw.primitive)));
  // One more point completes the next primitive of a strip, but not a separate one.
  const bool connected = each > 1 && is_vertex_count(draw.primitive, each + 1);
  return (connected ? connected_text(draw) : separate_text(draw)) + state_text(draw);
}

bool same_texture(const std::shared_ptr<const Texture>& a,
                  const std::shared_ptr<const Texture>& b) {
  return a == b || *a == *b;
}

}  // namespace

std::string scene_text(const Scene& scene) {
  std::string text;
  for (const Draw& draw : scene.draws) {
    if (!text.empty()) text += "; ";
    text += draw_text(draw);
  }
  if (!text.empty()) text += ", ";
  text += std::to_string(scene.target.width) + "x" + std::to_string(scene.target.height);
  if (scene.target.samples != 1) text += ", " + std::to_string(scene.target.samples) + " samples";
  if (!scene.supersampling.empty())
    text += ", " + std::to_string(scene.supersampling.size()) +
            (scene.supersampling.size() == 1 ? " pass" : " passes");
  if (scene.target.depth != DepthFormat::none)
    text += std::string(", ") + name_of(scene.target.depth);
  if (scene.target.stencil != StencilFormat::none)
    text += std::string(", ") + name_of(scene.target.stencil);
  if (scene.target.surface != Surface::fbo)
    text += std::string(", ") + name_of(scene.target.surface);
  return text;
}

bool same_scene(const Scene& a, const Scene& b) {
  return a.target == b.target && a.viewport == b.viewport && a.depth_range == b.depth_range &&
         a.details == b.details && a.supersampling == b.supersampling && a.draws == b.draws &&
         std::ranges::equal(a.textures, b.textures, same_texture);
}

}  // namespace edgecase
