// SPDX-License-Identifier: MIT
#include "diff/invariance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace edgecase {
namespace {

constexpr std::size_t kMostVariances = 64;

class Variances {
 public:
  Variances(const SceneImage& image, std::vector<Variance>& found)
      : image_(image), found_(found), most_(found.size() + kMostVariances) {}

  bool is_full() const { return found_.size() >= most_; }
  void add(PixelPosition pixel, int primitive, const std::string& what) {
    if (!is_full())
      found_.push_back(
          {pixel, primitive, image_.ruling, fmt::format("{}; the image {}", what, image_.text)});
  }

 private:
  const SceneImage& image_;
  std::vector<Variance>& found_;
  const std::size_t most_;
};

// To the last bit.
bool is_same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// What of a fragment differs, though both renderings report it; "" if nothing does.
std::string other_value(const Fragment& a, const Fragment& b) {
  if (a.coverage != b.coverage)
    return fmt::format("covers samples {:x} in the scene and {:x} in its image", a.coverage,
                       b.coverage);
  if (a.has_depth && b.has_depth && !is_same_number(a.depth, b.depth))
    return fmt::format("has depth {:.9g} in the scene and {:.9g} in its image", a.depth, b.depth);
  if (a.has_color && b.has_color && !std::ranges::equal(a.color, b.color, is_same_number))
    return fmt::format("has colour ({:.9g}) in the scene and ({:.9g}) in its image",
                       fmt::join(a.color, ", "), fmt::join(b.color, ", "));
  return "";
}

// The fragments of a drawing that are to be compared, in places and with numbers of the scene that
// the image is one of; sorted.
std::vector<std::pair<std::tuple<int, int, int>, const Fragment*>> compared(
    const SceneImage& image, const std::vector<Fragment>& fragments, bool is_second) {
  const auto [right, up, behind] =
      is_second ? std::tuple(image.right, image.up, image.behind) : std::tuple(0, 0, 0);
  std::vector<std::pair<std::tuple<int, int, int>, const Fragment*>> some;
  for (const Fragment& f : fragments) {
    const PixelPosition pixel{f.x - right, f.y - up};
    if (f.primitive < behind || (image.part && !image.part->contains(pixel))) continue;
    some.push_back({{pixel.y, pixel.x, f.primitive - behind}, &f});
  }
  return some;
}

void compare_fragments(const SceneImage& image, const Rendering& first, const Rendering& second,
                       Variances& variances) {
  const auto say = [&](const auto& key, const std::string& what) {
    const auto [y, x, primitive] = key;
    variances.add({x, y}, primitive, fmt::format("a fragment of primitive {} {}", primitive, what));
  };
  const auto all_a = compared(image, first.fragments, false);
  const auto all_b = compared(image, second.fragments, true);
  auto a = all_a.begin();
  auto b = all_b.begin();
  while ((a != all_a.end() || b != all_b.end()) && !variances.is_full()) {
    if (b == all_b.end() || (a != all_a.end() && a->first < b->first)) {
      say(a++->first, "is in the scene and not in its image");
    } else if (a == all_a.end() || b->first < a->first) {
      say(b++->first, "is in the image of the scene and not in the scene");
    } else {
      if (const std::string what = image.has_values ? other_value(*a->second, *b->second) : "";
          !what.empty())
        say(a->first, what);
      ++a;
      ++b;
    }
  }
}

// One plane of both drawings, or one for each sample.
template <class Number>
void compare_plane(const std::string& what, std::size_t components, const std::vector<Number>& a,
                   const std::vector<Number>& b, const SceneImage& image, const Rendering& size,
                   Variances& variances) {
  if (a.size() != b.size()) return;
  const std::size_t area = size.pixel_index(0, size.height);
  for (std::size_t i = 0; i < a.size() && !variances.is_full(); i += components) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const auto end = at + static_cast<std::ptrdiff_t>(components);
    if (std::equal(a.begin() + at, a.begin() + end, b.begin() + at, is_same_number)) continue;
    const std::size_t index = i / components;
    const auto pixel = static_cast<int>(index % area);
    const PixelPosition place{pixel % size.width, pixel / size.width};
    if (image.part && !image.part->contains(place)) continue;
    const std::string of = a.size() == area * components
                               ? std::string("the pixel")
                               : fmt::format("sample {} of the pixel", index / area);
    variances.add(place, -1, fmt::format("{} has two {} in two drawings", of, what));
  }
}

void compare_planes(const SceneImage& image, const Rendering& first, const Rendering& second,
                    Variances& variances) {
  const auto compare = [&](const char* what, std::size_t components, const auto& a, const auto& b) {
    compare_plane(what, components, a, b, image, first, variances);
  };
  if (image.has_pixels) {
    compare("colours", 4, first.pixels, second.pixels);
    compare("colours", 4, first.sample_pixels, second.sample_pixels);
    compare("sums of colours", 4, first.accumulated, second.accumulated);
  }
  if (image.has_tests) {
    compare("depths", 1, first.depths, second.depths);
    compare("stencil values", 1, first.stencils, second.stencils);
    compare("numbers of fragments", 1, first.hits, second.hits);
  }
}

}  // namespace

void find_variances(const SceneImage& image, const Rendering& first, const Rendering& second,
                    std::vector<Variance>& found) {
  Variances variances(image, found);
  compare_fragments(image, first, second, variances);
  compare_planes(image, first, second, variances);
  for (std::size_t i = 0; i < std::min(first.passes.size(), second.passes.size()); ++i) {
    compare_fragments(image, first.passes[i], second.passes[i], variances);
    compare_planes(image, first.passes[i], second.passes[i], variances);
  }
}

namespace {

// The pixel that holds the first vertex.
PixelPosition pixel_of_first(const ScenePrimitive& primitive) {
  const Point p = primitive.vertices[0]->position;
  return {static_cast<int>(p.x.floor()), static_cast<int>(p.y.floor())};
}

// What primitives of one draw have in common that are each other's images: the places of their
// vertices, from the pixel of the first one.
using Shape = std::pair<int, std::vector<std::pair<Fixed, Fixed>>>;

Shape shape_of(const ScenePrimitive& primitive) {
  const PixelPosition pixel = pixel_of_first(primitive);
  Shape shape{primitive.draw, {}};
  for (int v = 0; v < vertices_of(primitive.kind); ++v) {
    const Point p = primitive.vertices[static_cast<std::size_t>(v)]->position;
    shape.second.emplace_back(p.x - Fixed::from_integer(pixel.x),
                              p.y - Fixed::from_integer(pixel.y));
  }
  return shape;
}

// The fragments of each primitive, as places from the pixel of its first vertex.
std::vector<std::set<std::pair<int, int>>> places_of(const std::vector<ScenePrimitive>& primitives,
                                                     const Rendering& drawn) {
  std::vector<std::set<std::pair<int, int>>> places(primitives.size());
  for (const Fragment& f : drawn.fragments) {
    const auto index = static_cast<std::size_t>(f.primitive);
    const PixelPosition pixel = pixel_of_first(primitives[index]);
    places[index].insert({f.y - pixel.y, f.x - pixel.x});
  }
  return places;
}

bool may_have_moved(const Scene& scene) {
  constexpr std::size_t kMostVertices = 4096;
  const auto is_fine = [](int side) {
    return std::has_single_bit(static_cast<unsigned>(side)) && side <= 2 * kLargestMoved;
  };
  const Target& target = scene.target;
  std::size_t vertices = 0;
  for (const Draw& draw : scene.draws) vertices += draw.vertices.size();
  return target.samples == 1 && scene.supersampling.empty() && is_fine(target.width) &&
         is_fine(target.height) && is_whole_target(scene.viewport, target) &&
         vertices <= kMostVertices;
}

}  // namespace

void find_variances_of_primitives(const Scene& scene, const Rendering& drawn,
                                  std::vector<Variance>& found) {
  if (!may_have_moved(scene)) return;
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  std::map<Shape, std::size_t> firsts;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (primitives[i].state->scissor || !lies_inside(primitives[i], scene.target)) continue;
    const auto [first, is_new] = firsts.emplace(shape_of(primitives[i]), i);
    if (!is_new) pairs.emplace_back(first->second, i);
  }
  if (pairs.empty()) return;
  const auto places = places_of(primitives, drawn);
  for (const auto& pair : pairs) {
    const std::size_t first = pair.first;
    const std::size_t second = pair.second;
    const PixelPosition from = pixel_of_first(primitives[first]);
    const PixelPosition to = pixel_of_first(primitives[second]);
    SceneImage image;
    image.text = fmt::format("is primitive {}, which is moved by {} pixels to the right and {} up",
                             second, to.x - from.x, to.y - from.y);
    Variances variances(image, found);
    const auto say = [&](const std::pair<int, int>& place, const char* what) {
      variances.add({from.x + place.second, from.y + place.first}, static_cast<int>(first),
                    fmt::format("a fragment of primitive {} {}", first, what));
    };
    for (const auto& place : places[first])
      if (!places[second].contains(place)) say(place, "is not in its image");
    for (const auto& place : places[second])
      if (!places[first].contains(place)) say(place, "is in its image alone");
  }
}

}  // namespace edgecase
