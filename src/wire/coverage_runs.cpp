// SPDX-License-Identifier: MIT
//
// The hot path of whoever measures a driver over hundreds of thousands of scenes.
#include "wire/coverage_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>

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

}  // namespace edgecase::wire
