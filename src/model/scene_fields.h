// SPDX-License-Identifier: MIT
//
// The fields of a scene, each said once: its key in request lines and in case files, where it is
// kept, and which numbers it takes. Bytes and JSON on the wire, the reader and the writer of case
// files walk over these lists, so that a new field is a member, a row here and what draws it.
//
// A list's order is that of the keys in a request line, which a scene's digest is made of: rows are
// added where a line without them stays what it is.
#pragma once

#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/scene.h"

namespace edgecase {

// The numbers that a field takes, both ends inclusive; of a width or size the lower one is not.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

template <class Noun, class Value>
struct Field {
  const char* key;  // null: the value's own fields stand in its place
  Value Noun::*member;
  Limits limits;
  // A request line says it only where it is not the standard of a default-constructed noun. Values
  // that may be absent, and lists that may be empty, are never said then.
  bool is_left_out = false;
  // Case files have a form of their own for it.
  bool is_by_hand = false;
  // Its key and its name for people in case files, where these are others than `key`.
  const char* case_key = key;
  const char* title = case_key;

  constexpr Field left_out() const {
    Field other = *this;
    other.is_left_out = true;
    return other;
  }
  constexpr Field by_hand() const {
    Field other = *this;
    other.is_by_hand = true;
    return other;
  }
  constexpr Field called(const char* name) const {
    Field other = *this;
    other.title = name;
    return other;
  }
  constexpr Field in_cases(const char* name) const {
    Field other = *this;
    other.case_key = other.title = name;
    return other;
  }
};

template <class Noun, class Value>
constexpr Field<Noun, Value> field(const char* key, Value Noun::*member, Limits limits = {}) {
  return {key, member, limits};
}
template <class Noun, class Value>
constexpr Field<Noun, Value> fields_in(Value Noun::*member) {
  return {nullptr, member, {}};
}

// Of a type that has none, no list.
template <class Noun>
inline constexpr int kFields = 0;

template <class Noun>
concept HasFields = !std::is_same_v<std::remove_cv_t<decltype(kFields<Noun>)>, int>;

// Calls `visit` with each field of a noun, in their order.
template <HasFields Noun, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... fields) { (visit(fields), ...); }, kFields<Noun>);
}

constexpr int kMaxViewportOnWire = 32768;  // pixels along a side, and of a corner from the origin
constexpr double kMaxThickness = 64;       // pixels: a line's width, a point's size
constexpr float kMaxLod = 1000;            // largest magnitude of a level of detail
constexpr int kMostLevel = 1000;           // largest base_level and max_level
// 2^24 units are the whole depth of 24 bits.
constexpr double kMaxOffset = 16777216;
constexpr Limits kUnitInterval{0, 1};
constexpr Limits kByte{0, 255};

template <>
inline constexpr auto kFields<ClipPosition> =
    std::tuple{field("x", &ClipPosition::x), field("y", &ClipPosition::y),
               field("z", &ClipPosition::z), field("w", &ClipPosition::w)};

template <>
inline constexpr auto kFields<Vertex> =
    std::tuple{field("position", &Vertex::position),
               field("z", &Vertex::z),
               field("color", &Vertex::color),
               field("w", &Vertex::w),
               field("texture_coordinates", &Vertex::texture_coordinates),
               field("clip", &Vertex::clip)};

template <>
inline constexpr auto kFields<DepthRange> = std::tuple{
    field("near", &DepthRange::near, kUnitInterval), field("far", &DepthRange::far, kUnitInterval)};

template <>
inline constexpr auto kFields<Viewport> =
    std::tuple{field("x", &Viewport::x), field("y", &Viewport::y), field("width", &Viewport::width),
               field("height", &Viewport::height)};

template <>
inline constexpr auto kFields<Target> =
    std::tuple{field("width", &Target::width, {1, kMaxTargetSize}),
               field("height", &Target::height, {1, kMaxTargetSize}),
               field("samples", &Target::samples, {1, kMaxSamples}).by_hand(),
               field("sample_positions", &Target::sample_positions),
               field("color", &Target::color).called("a colour format"),
               field("depth", &Target::depth).left_out().by_hand().called("a depth format"),
               field("stencil", &Target::stencil).left_out().by_hand().called("a stencil format"),
               field("clear_depth", &Target::clear_depth, kUnitInterval).left_out(),
               field("clear_stencil", &Target::clear_stencil, kByte).left_out(),
               field("surface", &Target::surface).called("a surface"),
               field("clear", &Target::clear, kUnitInterval).called("a clear colour")};

template <>
inline constexpr auto kFields<Multisampling> =
    std::tuple{field("enabled", &Multisampling::enabled).in_cases("multisample"),
               field("location", &Multisampling::location).in_cases("attribute_location"),
               field("min_sample_shading", &Multisampling::min_sample_shading, kUnitInterval),
               field("mask", &Multisampling::mask).in_cases("sample_mask"),
               field("alpha_to_coverage", &Multisampling::alpha_to_coverage)};

template <>
inline constexpr auto kFields<Sampler> =
    std::tuple{field("wrap", &Sampler::wrap),
               field("magnify", &Sampler::magnify),
               field("minify", &Sampler::minify),
               field("mipmap", &Sampler::mipmap),
               field("lod_bias", &Sampler::lod_bias, {-kMaxLodBias, kMaxLodBias}),
               field("min_lod", &Sampler::min_lod, {-kMaxLod, kMaxLod}),
               field("max_lod", &Sampler::max_lod, {-kMaxLod, kMaxLod}),
               field("base_level", &Sampler::base_level, {0, kMostLevel}),
               field("max_level", &Sampler::max_level, {0, kMostLevel}),
               field("border", &Sampler::border),
               field("max_anisotropy", &Sampler::max_anisotropy, {1, kMaxAnisotropy})};

template <>
inline constexpr auto kFields<Lookup> =
    std::tuple{field("kind", &Lookup::kind), field("value", &Lookup::value),
               field("dx", &Lookup::dx), field("dy", &Lookup::dy)};

template <>
inline constexpr auto kFields<TextureUse> =
    std::tuple{field("texture", &TextureUse::texture), fields_in(&TextureUse::sampler),
               field("lookup", &TextureUse::lookup)};

// An offset of more than 1 leaves the depth buffer wherever it starts.
template <>
inline constexpr auto kFields<PolygonOffset> =
    std::tuple{field("factor", &PolygonOffset::factor, {-kMaxOffset, kMaxOffset}),
               field("units", &PolygonOffset::units, {-kMaxOffset, kMaxOffset}),
               field("clamp", &PolygonOffset::clamp, {-1, 1})};

template <>
inline constexpr auto kFields<StencilFace> =
    std::tuple{field("test", &StencilFace::function).called("a stencil test"),
               field("reference", &StencilFace::reference, kByte),
               field("read_mask", &StencilFace::read_mask, kByte),
               field("write_mask", &StencilFace::write_mask, kByte),
               field("fail", &StencilFace::fail),
               field("depth_fail", &StencilFace::depth_fail),
               field("pass", &StencilFace::pass)};

template <>
inline constexpr auto kFields<StencilTest> =
    std::tuple{field("front", &StencilTest::front), field("back", &StencilTest::back)};

template <>
inline constexpr auto kFields<DepthTest> = std::tuple{
    field("test", &DepthTest::function).called("a depth test"), field("write", &DepthTest::write)};

template <>
inline constexpr auto kFields<BlendTerm> =
    std::tuple{field("equation", &BlendTerm::equation), field("source", &BlendTerm::source),
               field("destination", &BlendTerm::destination)};

template <>
inline constexpr auto kFields<Blending> =
    std::tuple{field("color", &Blending::color), field("alpha", &Blending::alpha),
               field("constant", &Blending::constant, kUnitInterval)};

template <>
inline constexpr auto kFields<FragmentOperations> =
    std::tuple{field("stencil", &FragmentOperations::stencil),
               field("depth", &FragmentOperations::depth).left_out(),
               field("blend", &FragmentOperations::blending),
               field("color_mask", &FragmentOperations::color_mask).left_out()};

template <>
inline constexpr auto kFields<Draw> =
    std::tuple{field("primitive", &Draw::primitive).by_hand().called("a primitive"),
               field("interpolation", &Draw::interpolation),
               field("provoking_vertex", &Draw::provoking_vertex).called("the provoking vertex"),
               field("line_width", &Draw::line_width, {0, kMaxThickness}),
               field("point_size", &Draw::point_size, {0, kMaxThickness}),
               field("scissor", &Draw::scissor, {0, kMaxViewportOnWire}),
               field("multisampling", &Draw::multisampling),
               field("texture", &Draw::texture),
               field("front_face", &Draw::front_face).left_out().called("the front face"),
               field("cull", &Draw::cull).left_out(),
               field("polygon_offset", &Draw::polygon_offset),
               fields_in(&Draw::operations),
               field("vertices", &Draw::vertices)};

template <>
inline constexpr auto kFields<Details> =
    std::tuple{field("coordinates", &Details::coordinates),
               field("derivatives", &Details::derivatives), field("texture", &Details::texture)};

template <>
inline constexpr auto kFields<TextureLevel> =
    std::tuple{field("width", &TextureLevel::width, {1, kMaxTextureSize}),
               field("height", &TextureLevel::height, {1, kMaxTextureSize}),
               field("texels", &TextureLevel::texels)};

template <>
inline constexpr auto kFields<Texture> =
    std::tuple{field("dimensions", &Texture::dimensions, {1, 2}), field("format", &Texture::format),
               field("levels", &Texture::levels), field("generated", &Texture::generated)};

template <>
inline constexpr auto kFields<ShadingPass> =
    std::tuple{field("at", &ShadingPass::at), field("weight", &ShadingPass::weight)};

template <>
inline constexpr auto kFields<Scene> =
    std::tuple{field("target", &Scene::target),
               field("viewport", &Scene::viewport, {1, kMaxViewportOnWire}),
               field("depth_range", &Scene::depth_range).left_out(),
               field("details", &Scene::details).left_out(),
               field("textures", &Scene::textures),
               field("draws", &Scene::draws),
               field("supersampling", &Scene::supersampling)};

}  // namespace edgecase
