// SPDX-License-Identifier: MIT
#include "reference/drawn_keys.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "model/scene_fields.h"

namespace edgecase {

namespace {

template <HasFields Noun>
constexpr std::array<const char*, 0> kDrawn{};

template <>
constexpr std::array kDrawn<Scene>{"target",   "viewport", "depth_range",  "details",
                                   "textures", "draws",    "supersampling"};
template <>
constexpr std::array kDrawn<Target>{"width", "height",        "samples", "sample_positions",
                                    "color", "depth",         "stencil", "clear_depth",
                                    "clear", "clear_stencil", "surface"};
template <>
constexpr std::array kDrawn<Viewport>{"x", "y", "width", "height"};
template <>
constexpr std::array kDrawn<DepthRange>{"near", "far"};
template <>
constexpr std::array kDrawn<Details>{"coordinates", "derivatives", "texture"};
template <>
constexpr std::array kDrawn<ShadingPass>{"at", "weight"};
template <>
constexpr std::array kDrawn<Texture>{"dimensions", "format", "levels", "generated"};
template <>
constexpr std::array kDrawn<TextureLevel>{"width", "height", "texels"};
template <>
constexpr std::array kDrawn<Draw>{"primitive",  "interpolation", "provoking_vertex", "line_width",
                                  "point_size", "scissor",       "multisampling",    "texture",
                                  "front_face", "cull",          "polygon_offset",   "stencil",
                                  "depth",      "blend",         "color_mask",       "vertices"};
template <>
constexpr std::array kDrawn<Multisampling>{"enabled", "location", "min_sample_shading", "mask",
                                           "alpha_to_coverage"};
template <>
constexpr std::array kDrawn<TextureUse>{
    "texture", "wrap",   "magnify",    "minify",    "mipmap",         "lod_bias", "min_lod",
    "max_lod", "border", "base_level", "max_level", "max_anisotropy", "lookup"};
template <>
constexpr std::array kDrawn<Lookup>{"kind", "value", "dx", "dy"};
template <>
constexpr std::array kDrawn<PolygonOffset>{"factor", "units", "clamp"};
template <>
constexpr std::array kDrawn<StencilTest>{"front", "back"};
template <>
constexpr std::array kDrawn<StencilFace>{"test", "reference",  "read_mask", "write_mask",
                                         "fail", "depth_fail", "pass"};
template <>
constexpr std::array kDrawn<DepthTest>{"test", "write"};
template <>
constexpr std::array kDrawn<Blending>{"color", "alpha", "constant"};
template <>
constexpr std::array kDrawn<BlendTerm>{"equation", "source", "destination"};
template <>
constexpr std::array kDrawn<Vertex>{"position", "z", "color", "w", "texture_coordinates", "clip"};
template <>
constexpr std::array kDrawn<ClipPosition>{"x", "y", "z", "w"};

// What holds no nouns.
template <class Value>
constexpr const char* key_within(const Value&) {
  return nullptr;
}

template <HasFields Noun>
const char* key_within(const Noun& noun);

template <HasFields Noun>
const char* key_within(const std::optional<Noun>& noun) {
  return noun ? key_within(*noun) : nullptr;
}

template <HasFields Noun>
const char* key_within(const std::shared_ptr<const Noun>& noun) {
  return key_within(*noun);
}

template <class Item>
const char* key_within(const std::vector<Item>& items) {
  const char* key = nullptr;
  for (const Item& item : items)
    if (key == nullptr) key = key_within(item);
  return key;
}

template <HasFields Noun>
const char* key_within(const Noun& noun) {
  static const Noun standard;
  const char* key = nullptr;
  for_each_row<Noun>([&](const auto& field, const auto& part) {
    const auto& value = part(noun).*field.member;
    const auto is_key = [&](std::string_view drawn) { return drawn == field.key; };
    if (key != nullptr) return;
    if (std::ranges::any_of(kDrawn<Noun>, is_key))
      key = key_within(value);
    else if (!(value == part(standard).*field.member))
      key = field.key;
  });
  return key;
}

}  // namespace

std::string key_not_drawn(const Scene& scene) {
  const char* key = key_within(scene);
  return key != nullptr ? key : "";
}

}  // namespace edgecase
