// SPDX-License-Identifier: MIT
#include "reference/drawn_keys.h"

#include <algorithm>
#include <array>
#include <string_view>

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
constexpr std::array kDrawn<Multisampling>{"enabled", "location", "min_sample_shading", "mask",
                                           "alpha_to_coverage"};
template <>
constexpr std::array kDrawn<Sampler>{"wrap",      "magnify", "minify",        "mipmap",
                                     "lod_bias",  "min_lod", "max_lod",       "base_level",
                                     "max_level", "border",  "max_anisotropy"};
template <>
constexpr std::array kDrawn<Draw>{"primitive",  "interpolation", "provoking_vertex", "line_width",
                                  "point_size", "scissor",       "multisampling",    "texture",
                                  "front_face", "cull",          "polygon_offset",   "stencil",
                                  "depth",      "blend",         "color_mask",       "vertices"};

template <HasFields Noun>
const char* key_not_drawn_of(const Noun& noun) {
  static const Noun standard;
  const char* key = nullptr;
  for_each_row<Noun>([&](const auto& field, const auto& part) {
    const auto is_key = [&](std::string_view drawn) { return drawn == field.key; };
    if (std::ranges::none_of(kDrawn<Noun>, is_key) &&
        !(part(noun).*field.member == part(standard).*field.member))
      key = field.key;
  });
  return key;
}

}  // namespace

std::string key_not_drawn(const Scene& scene) {
  const char* key = key_not_drawn_of(scene);
  if (key == nullptr) key = key_not_drawn_of(scene.target);
  for (const Draw& draw : scene.draws) {
    if (key == nullptr) key = key_not_drawn_of(draw);
    if (key == nullptr) key = key_not_drawn_of(draw.multisampling);
    if (key == nullptr && draw.texture) key = key_not_drawn_of(draw.texture->sampler);
  }
  return key != nullptr ? key : "";
}

}  // namespace edgecase
