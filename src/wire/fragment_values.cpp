// SPDX-License-Identifier: MIT
#include "wire/fragment_values.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "wire/rendering_json.h"

namespace edgecase::wire {

using nlohmann::json;

namespace {

// What the fragments of one scene must keep to.
struct Bounds {
  int width;
  int height;
  int samples;
  const std::vector<bool>& textured;  // by primitive: is its draw?
  Details details;                    // what was asked for
};

template <std::size_t N>
void read_numbers(const json& value, const Path& path, std::array<double, N>& numbers) {
  require_array(value, path, N);
  for (std::size_t i = 0; i < N; ++i) numbers[i] = read_number(value[i], {path, i});
}

void read_derivatives(const json& value, const Path& path, FragmentDetail& detail) {
  require_object(value, path,
                 {kDerivativeNames[0], kDerivativeNames[1], kDerivativeNames[2],
                  kDerivativeNames[3], kDerivativeNames[4], kDerivativeNames[5]});
  for (std::size_t i = 0; i < kDerivatives; ++i) {
    const json* four = optional_member(value, kDerivativeNames[i]);
    if (four == nullptr) continue;
    read_numbers(*four, {path, kDerivativeNames[i]}, detail.derivatives[i]);
    detail.has_derivative[i] = true;
  }
}

// What a fragment tells beside colour and depth; none where it tells nothing of the kind.
std::optional<FragmentDetail> read_detail(const json& value, const Path& path, Details asked,
                                          bool is_textured) {
  const auto find = [&](const char* key, bool is_asked, bool is_there = true) {
    const json* found = optional_member(value, key);
    if (found != nullptr && !is_asked)
      throw Refusal(
          fmt::format("{} has \"{}\", which the request does not ask for", path.text(), key));
    if (found != nullptr && !is_there)
      throw Refusal(fmt::format("{} has \"{}\", but its draw has no texture", path.text(), key));
    return found;
  };
  const json* coordinates = find("coordinates", asked.coordinates);
  const json* derivatives = find("derivatives", asked.derivatives);
  const json* texture = find("texture_coordinates", asked.texture, is_textured);
  const json* level = find("level_of_detail", asked.texture, is_textured);
  if (coordinates == nullptr && derivatives == nullptr && texture == nullptr && level == nullptr)
    return std::nullopt;
  FragmentDetail detail;
  const auto read = [&](const json* found, const char* key, auto& numbers) {
    if (found != nullptr) read_numbers(*found, {path, key}, numbers);
    return found != nullptr;
  };
  detail.has_coordinates = read(coordinates, "coordinates", detail.coordinates);
  detail.has_texture_coordinates = read(texture, "texture_coordinates", detail.texture_coordinates);
  detail.has_level_of_detail = read(level, "level_of_detail", detail.level_of_detail);
  if (derivatives != nullptr) read_derivatives(*derivatives, {path, "derivatives"}, detail);
  return detail;
}

Fragment read_fragment(const json& value, const Path& path, const Bounds& bounds) {
  require_object(value, path,
                 {"x", "y", "primitive", "coverage", "depth", "color", "coordinates", "derivatives",
                  "texture_coordinates", "level_of_detail"});
  const auto read_index = [&](const char* key, int count) {
    return static_cast<int>(read_integer(member(value, path, key), {path, key}, 0, count - 1));
  };
  Fragment fragment;
  fragment.x = read_index("x", bounds.width);
  fragment.y = read_index("y", bounds.height);
  fragment.primitive = read_index("primitive", static_cast<int>(bounds.textured.size()));
  const json* coverage = optional_member(value, "coverage");
  if (coverage == nullptr && bounds.samples > 1)
    throw Refusal(path.text() + " has no \"coverage\", and the target has several samples");
  if (coverage != nullptr)
    fragment.coverage = static_cast<std::uint32_t>(
        read_integer(*coverage, {path, "coverage"}, 1, (std::int64_t{1} << bounds.samples) - 1));
  const json* depth = optional_member(value, "depth");
  fragment.has_depth = depth != nullptr;
  if (depth != nullptr) fragment.depth = read_number(*depth, {path, "depth"});
  const json* color = optional_member(value, "color");
  fragment.has_color = color != nullptr;
  if (color != nullptr) read_numbers(*color, {path, "color"}, fragment.color);
  return fragment;
}

}  // namespace

std::vector<bool> textured_primitives(const Scene& scene) {
  std::vector<bool> textured;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    textured.push_back(primitive.state->texture.has_value());
  return textured;
}

void read_fragments(const json& value, const Path& path, const Scene& scene,
                    const std::vector<bool>& textured, Rendering& rendering) {
  const Bounds bounds{rendering.width, rendering.height, rendering.samples, textured,
                      scene.details};
  require_array(value, path, value.size());
  rendering.fragments.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Path at(path, i);
    Fragment fragment = read_fragment(value[i], at, bounds);
    const bool is_textured = bounds.textured[static_cast<std::size_t>(fragment.primitive)];
    if (const auto detail = read_detail(value[i], at, bounds.details, is_textured)) {
      fragment.detail = static_cast<int>(rendering.details.size());
      rendering.details.push_back(*detail);
    }
    rendering.fragments.push_back(fragment);
  }
}

}  // namespace edgecase::wire
