// SPDX-License-Identifier: MIT
//
// The hot path of whoever measures a driver over hundreds of thousands of scenes.
#include "wire/fragments_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "wire/rendering_json.h"

namespace edgecase::wire {

using nlohmann::json;

namespace {

constexpr std::size_t kNumbersPerRun = 4;

struct Place {
  int primitive;
  int y;
  int x;
};

bool comes_before(const Place& a, const Place& b) {
  return std::tie(a.primitive, a.y, a.x) < std::tie(b.primitive, b.y, b.x);
}

std::vector<Place> places_by_primitive(const Rendering& rendering) {
  std::vector<Place> places;
  places.reserve(rendering.fragments.size());
  for (const Fragment& fragment : rendering.fragments)
    places.push_back({fragment.primitive, fragment.y, fragment.x});
  if (!std::is_sorted(places.begin(), places.end(), comes_before))
    std::sort(places.begin(), places.end(), comes_before);
  return places;
}

// The fragments of runs of which `read(index, low, high)` reads a number within limits. `what`: how
// to call the array.
template <class Read>
std::vector<Fragment> fragments_of(std::size_t numbers, const std::string& what,
                                   const RunBounds& bounds, Read read) {
  if (numbers % kNumbersPerRun != 0)
    throw Refusal(fmt::format("{} must have four numbers for each run, but it has {} elements",
                              what, numbers));
  std::vector<Fragment> fragments;
  Fragment fragment;
  fragment.has_depth = fragment.has_color = false;
  for (std::size_t run = 0; run < numbers; run += kNumbersPerRun) {
    fragment.primitive = read(run, 0, bounds.primitives - 1);
    fragment.y = read(run + 1, 0, bounds.height - 1);
    const int first = read(run + 2, 0, bounds.width - 1);
    const int last = read(run + 3, first, bounds.width - 1);
    if (fragments.size() + static_cast<std::size_t>(last - first) >= kMostFragments)
      throw Refusal(fmt::format("{} has more than {} fragments", what, kMostFragments));
    for (fragment.x = first; fragment.x <= last; ++fragment.x) fragments.push_back(fragment);
  }
  return fragments;
}

}  // namespace

std::vector<int> coverage_runs(const Rendering& rendering) {
  const std::vector<Place> places = places_by_primitive(rendering);
  std::vector<int> numbers;
  for (auto first = places.begin(); first != places.end();) {
    auto last = first;
    while (last + 1 != places.end() && last[1].primitive == first->primitive &&
           last[1].y == first->y && last[1].x == last->x + 1)
      ++last;
    numbers.insert(numbers.end(), {first->primitive, first->y, first->x, last->x});
    first = last + 1;
  }
  return numbers;
}

std::string coverage_runs_json(const Rendering& rendering) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "[{}]", fmt::join(coverage_runs(rendering), ","));
  return fmt::to_string(text);
}

std::vector<Fragment> read_coverage_runs(const json& value, const Path& path,
                                         const RunBounds& bounds) {
  require_array(value, path, value.size());
  return fragments_of(value.size(), path.text(), bounds, [&](std::size_t index, int low, int high) {
    return read_int(value[index], {path, index}, low, high);
  });
}

std::vector<Fragment> fragments_of_runs(const std::vector<int>& numbers, const RunBounds& bounds) {
  return fragments_of(
      numbers.size(), "the coverage", bounds, [&](std::size_t index, int low, int high) {
        if (numbers[index] < low || numbers[index] > high)
          throw Refusal(fmt::format("number {} of the coverage is {}, but it must be {} to {}",
                                    index, numbers[index], low, high));
        return numbers[index];
      });
}

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
    read_numbers(*four, {path, kDerivativeNames[i]}, detail.derivatives[i].emplace());
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
    if (found != nullptr) read_numbers(*found, {path, key}, numbers.emplace());
  };
  read(coordinates, "coordinates", detail.coordinates);
  read(texture, "texture_coordinates", detail.texture_coordinates);
  read(level, "level_of_detail", detail.level_of_detail);
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
