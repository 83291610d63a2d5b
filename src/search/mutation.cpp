// SPDX-License-Identifier: MIT
#include "search/mutation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "casefile/case_writer.h"
#include "casefile/scene/viewport.h"
#include "model/rule_id.h"

namespace edgecase {
namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kTries = 8;
constexpr int kMostTarget = 256;  // pixels: larger ones only cost time

// Each change returns false if it does not apply to the scene.
using Change = bool (*)(Scene&, RandomSource&);

bool is_movable(const Scene& scene) {
  return !scene.draws.empty() && !has_clip_vertices(scene.draws);
}

Draw& any_draw(Scene& scene, RandomSource& random) {
  return scene
      .draws[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scene.draws.size())))];
}

std::size_t any_place(const Draw& draw, RandomSource& random) {
  return static_cast<std::size_t>(random.below(static_cast<std::int64_t>(draw.vertices.size())));
}

// Shared vertices usually stay shared: joints and shared edges need equal bits.
void move(Draw& draw, std::size_t place, Point to, RandomSource& random) {
  const Point from = draw.vertices[place].position;
  if (random.one_in(4)) {
    draw.vertices[place].position = to;
    return;
  }
  for (Vertex& vertex : draw.vertices)
    if (vertex.position == from) vertex.position = to;
}

bool nudge_vertex(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  Draw& draw = any_draw(scene, random);
  const std::size_t place = any_place(draw, random);
  const std::int64_t length = random.sign() * (kOne >> random.between(4, 16));
  const std::int64_t ways = random.below(3);
  Point to = draw.vertices[place].position;
  if (ways != 0) to.x = Fixed::from_raw(to.x.raw() + length);
  if (ways != 1) to.y = Fixed::from_raw(to.y.raw() + (random.one_in(2) ? length : -length));
  move(draw, place, to, random);
  return true;
}

Fixed nearest_multiple(Fixed value, std::int64_t step, std::int64_t offset) {
  const std::int64_t from = value.raw() - offset + step / 2;
  const std::int64_t down = from >= 0 ? from / step : -((step - 1 - from) / step);
  return Fixed::from_raw(down * step + offset);
}

// Moves a vertex to the centre of a pixel or a corner of a diamond.
bool move_to_tie(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  Draw& draw = any_draw(scene, random);
  const std::size_t place = any_place(draw, random);
  const Point from = draw.vertices[place].position;
  const std::int64_t kind = random.below(4);
  const std::int64_t x = kind == 0 || kind == 1 ? kOne / 2 : 0;
  const std::int64_t y = kind == 0 || kind == 2 ? kOne / 2 : 0;
  move(draw, place, {nearest_multiple(from.x, kOne, x), nearest_multiple(from.y, kOne, y)}, random);
  return true;
}

// Moves a vertex so that the middle between it and its neighbour is a pixel's centre.
bool move_edge_to_centre(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  Draw& draw = any_draw(scene, random);
  if (draw.vertices.size() < 2) return false;
  const std::size_t place = any_place(draw, random);
  const Point from = draw.vertices[place].position;
  const Point other = draw.vertices[(place + 1) % draw.vertices.size()].position;
  const auto moved = [](Fixed own, Fixed fixed) {
    const Fixed middle = Fixed::from_raw((own.raw() + fixed.raw()) / 2);
    return Fixed::from_raw(2 * nearest_multiple(middle, kOne, kOne / 2).raw() - fixed.raw());
  };
  move(draw, place, {moved(from.x, other.x), moved(from.y, other.y)}, random);
  return true;
}

// The number of consecutive vertices that can be removed or doubled.
std::size_t group_of(const Draw& draw) {
  switch (draw.primitive) {
    case Primitive::lines:
      return 2;
    case Primitive::triangles:
      return 3;
    case Primitive::points:
    case Primitive::line_strip:
    case Primitive::line_loop:
    case Primitive::triangle_strip:
    case Primitive::triangle_fan:
      return 1;
  }
  return 1;
}

bool drop_primitive(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  if (scene.draws.size() > 1 && random.one_in(2)) {
    scene.draws.erase(scene.draws.begin() +
                      random.below(static_cast<std::int64_t>(scene.draws.size())));
    return true;
  }
  Draw& draw = any_draw(scene, random);
  const std::size_t group = group_of(draw);
  if (!is_vertex_count(draw.primitive, draw.vertices.size() - group)) return false;
  const auto first =
      draw.vertices.begin() + static_cast<std::ptrdiff_t>(any_place(draw, random) / group * group);
  draw.vertices.erase(first, first + static_cast<std::ptrdiff_t>(group));
  return true;
}

bool duplicate_primitive(Scene& scene, RandomSource& random) {
  if (scene.draws.empty() || primitives_of(scene).size() > 64) return false;
  if (random.one_in(2)) {
    scene.draws.push_back(any_draw(scene, random));
    return true;
  }
  Draw& draw = any_draw(scene, random);
  const std::size_t group = group_of(draw);
  const std::size_t first = any_place(draw, random) / group * group;
  const std::vector<Vertex> copy(
      draw.vertices.begin() + static_cast<std::ptrdiff_t>(first),
      draw.vertices.begin() + static_cast<std::ptrdiff_t>(first + group));
  draw.vertices.insert(draw.vertices.end(), copy.begin(), copy.end());
  return is_vertex_count(draw.primitive, draw.vertices.size());
}

bool swap_vertices(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  Draw& draw = any_draw(scene, random);
  const std::size_t a = any_place(draw, random);
  const std::size_t b = any_place(draw, random);
  std::swap(draw.vertices[a], draw.vertices[b]);
  return a != b;
}

bool reverse_order(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  if (scene.draws.size() > 1 && random.one_in(2)) {
    std::reverse(scene.draws.begin(), scene.draws.end());
    return true;
  }
  Draw& draw = any_draw(scene, random);
  std::reverse(draw.vertices.begin(), draw.vertices.end());
  return draw.vertices.size() > 1;
}

bool change_interpolation(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  any_draw(scene, random).interpolation = static_cast<Interpolation>(random.below(3));
  return true;
}

bool change_provoking_vertex(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  ProvokingVertex& vertex = any_draw(scene, random).provoking_vertex;
  vertex = vertex == ProvokingVertex::first ? ProvokingVertex::last : ProvokingVertex::first;
  return true;
}

// The width of lines or the size of points: usually a pixel, or any quarters up to eight.
bool change_width(Scene& scene, RandomSource& random) {
  if (scene.draws.empty()) return false;
  Draw& draw = any_draw(scene, random);
  const PrimitiveKind kind = kind_of(draw.primitive);
  if (kind == PrimitiveKind::triangle) return false;
  const std::int64_t quarters = random.one_in(4) ? 4 : random.between(5, 32);
  (kind == PrimitiveKind::line ? draw.line_width : draw.point_size) =
      Fixed::from_raw(quarters * kOne / 4);
  return true;
}

bool change_samples(Scene& scene, RandomSource& random) {
  if (scene.target.surface != Surface::fbo) return false;
  constexpr std::array kSamples{1, 2, 4, 4, 8};
  scene.target.samples = random.one_of(std::span<const int>(kSamples));
  scene.target.sample_positions.clear();
  return true;
}

void for_every_point(Scene& scene, auto&& change) {
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) change(vertex.position);
}

bool transpose(Scene& scene, RandomSource&) {
  if (!is_movable(scene)) return false;
  for_every_point(scene, [](Point& p) { std::swap(p.x, p.y); });
  std::swap(scene.target.width, scene.target.height);
  return true;
}

// Reflects rows, columns or both about the target's middle.
bool mirror(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  const std::int64_t ways = random.below(3);
  const Target& target = scene.target;
  for_every_point(scene, [&](Point& p) {
    if (ways != 0) p.x = Fixed::from_raw(target.width * kOne - p.x.raw());
    if (ways != 1) p.y = Fixed::from_raw(target.height * kOne - p.y.raw());
  });
  return true;
}

// Moves by up to the target's size, so that parts may lie beyond it.
bool translate(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  const std::int64_t most = random.one_in(2) ? 2 : scene.target.width;
  const std::int64_t dx = random.between(-most, most) * kOne;
  const std::int64_t dy = random.between(-most, most) * kOne;
  for_every_point(scene, [&](Point& p) {
    p = {Fixed::from_raw(p.x.raw() + dx), Fixed::from_raw(p.y.raw() + dy)};
  });
  return dx != 0 || dy != 0;
}

bool change_target(Scene& scene, RandomSource& random) {
  if (!is_movable(scene)) return false;
  const auto change = [&](int& side) {
    const std::int64_t way = random.below(4);
    side = way == 0 ? 2 * side : way == 1 ? (side + 1) / 2 : way == 2 ? side + 1 : side - 1;
    side = std::clamp(side, 1, kMostTarget);
  };
  if (!random.one_in(3)) change(scene.target.width);
  if (!random.one_in(3)) change(scene.target.height);
  return true;
}

// Changes of coordinates are the most frequent.
constexpr std::array<Change, 20> kChanges{nudge_vertex,
                                          nudge_vertex,
                                          nudge_vertex,
                                          move_to_tie,
                                          move_to_tie,
                                          nudge_vertex,
                                          move_edge_to_centre,
                                          move_edge_to_centre,
                                          drop_primitive,
                                          swap_vertices,
                                          duplicate_primitive,
                                          reverse_order,
                                          change_interpolation,
                                          change_width,
                                          change_provoking_vertex,
                                          change_samples,
                                          transpose,
                                          mirror,
                                          translate,
                                          change_target};

// Chooses the viewport from target and vertices, as for a case file without one.
bool settle(Scene& scene) {
  if (!is_movable(scene)) return true;
  const auto viewport = choose_viewport(scene.target, scene.draws, scene.supersampling);
  if (!viewport) return false;
  scene.viewport = *viewport;
  return true;
}

bool can_be_said(const Scene& scene) {
  CaseWords words;
  words.title = "A mutated scene";
  words.rules = {name_of(RuleId::fragment_once)};
  return case_text(scene, words).diagnostics.empty();
}

}  // namespace

std::optional<Scene> mutated(const Scene& scene, RandomSource& random) {
  for (int i = 0; i < kTries; ++i) {
    Scene result = scene;
    const std::int64_t changes = random.between(1, 3);
    bool changed = true;
    for (std::int64_t k = 0; k < changes && changed; ++k)
      changed = random.one_of(std::span<const Change>(kChanges))(result, random);
    if (changed && settle(result) && !same_scene(result, scene) && can_be_said(result))
      return result;
  }
  return std::nullopt;
}

}  // namespace edgecase
