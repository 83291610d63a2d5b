// SPDX-License-Identifier: MIT
//
// This is a hot path when a driver is measured over hundreds of thousands of scenes.
#include "wire/fragments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "model/rendering_fields.h"

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

// The fragments of an array of runs; `read(index, low, high)` reads a number within limits. `what`:
// the array's name in messages.
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

// The limits for the fragments of one scene.
struct Bounds {
  int width;
  int height;
  int samples;
  const std::vector<bool>& textured;  // by primitive: whether its draw has a texture
  Details details;                    // the requested ones
};

template <std::size_t N>
void read_numbers(const json& value, const Path& path, std::array<double, N>& numbers) {
  require_array(value, path, N);
  for (std::size_t i = 0; i < N; ++i) numbers[i] = read_number(value[i], {path, i});
}

template <std::size_t N>
void read_reported(const json& value, const Path& path,
                   std::optional<std::array<double, N>>& numbers) {
  read_numbers(value, path, numbers.emplace());
}

// An object with the derivatives that are reported.
void read_reported(const json& value, const Path& path, DerivativeValues& derivatives) {
  static const std::vector<const char*> kKeys = [] {
    std::vector<const char*> keys;
    for (const auto& row : kNames<Derivative>) keys.push_back(row.name);
    return keys;
  }();
  require_object(value, path, kKeys);
  for (std::size_t i = 0; i < kDerivatives; ++i)
    if (const json* four = optional_member(value, kKeys[i]))
      read_reported(*four, {path, kKeys[i]}, derivatives[i]);
}

// The further values of a fragment; nothing if it has none.
std::optional<FragmentDetail> read_detail(const json& value, const Path& path, Details asked,
                                          bool is_textured) {
  std::optional<FragmentDetail> detail;
  for_each_field<FragmentDetail>([&](const auto& field) {
    const json* found = optional_member(value, field.key);
    if (found == nullptr) return;
    if (!(asked.*field.asked))
      throw Refusal(
          fmt::format("{} has \"{}\", which the request does not ask for", path.text(), field.key));
    if (!field.is_asked(asked, is_textured))
      throw Refusal(
          fmt::format("{} has \"{}\", but its draw has no texture", path.text(), field.key));
    if (!detail) detail.emplace();
    read_reported(*found, {path, field.key}, *detail.*field.member);
  });
  return detail;
}

Fragment read_fragment(const json& value, const Path& path, const Bounds& bounds) {
  static const std::vector<const char*> kKeys = [] {
    std::vector<const char*> keys{"x", "y", "primitive", "coverage", "depth", "color"};
    for_each_field<FragmentDetail>([&](const auto& field) { keys.push_back(field.key); });
    return keys;
  }();
  require_object(value, path, kKeys);
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

// To judge far more fragments would take a thirtieth of a millisecond for each, outside of any
// limit of time.
void check_count(std::size_t count, const Path& path, const Rendering& rendering,
                 std::size_t primitives) {
  const std::size_t samples = rendering.pixel_index(0, rendering.height) *
                              static_cast<std::size_t>(std::max(1, rendering.samples));
  if (count > kMostOfPrimitive * primitives * samples)
    throw Refusal(
        fmt::format("{} has {} elements, more than {} for each of {} primitives in each "
                    "of {} samples",
                    path.text(), count, kMostOfPrimitive, primitives, samples));
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
  check_count(value.size(), path, rendering, textured.size());
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
