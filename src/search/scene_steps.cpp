// SPDX-License-Identifier: MIT
#include "search/scene_steps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "casefile/scene/viewport.h"

namespace edgecase {
namespace {

Primitive separate_form(Primitive primitive) {
  switch (kind_of(primitive)) {
    case PrimitiveKind::point:
      return Primitive::points;
    case PrimitiveKind::line:
      return Primitive::lines;
    case PrimitiveKind::triangle:
      return Primitive::triangles;
  }
  return primitive;
}

bool is_separate(const Draw& draw) {
  return draw.primitive == separate_form(draw.primitive);
}

Scene all_separated(const Scene& scene) {
  Scene result = scene;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) result.draws[d] = separated(scene, d);
  return result;
}

// The scene reduced to some primitives, by index in drawing order; all of its draws must be
// separate.
Scene only(const Scene& scene, const std::set<int>& kept) {
  Scene result = scene;
  for (Draw& draw : result.draws) draw.vertices.clear();
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    if (!kept.contains(primitive.index)) continue;
    std::vector<Vertex>& vertices = result.draws[static_cast<std::size_t>(primitive.draw)].vertices;
    for (int v = 0; v < vertices_of(primitive.kind); ++v)
      vertices.push_back(*primitive.vertices[static_cast<std::size_t>(v)]);
  }
  std::erase_if(result.draws, [](const Draw& draw) { return draw.vertices.empty(); });
  return result;
}

// Makes a scene without the items [begin, end); nothing if that is not a scene.
using LeaveOut =
    std::function<std::optional<Scene>(const Scene&, std::size_t begin, std::size_t end)>;

// Removes as many items as possible, in runs of a half, a quarter, ... of them, down to single
// ones. `count` gives the number in a scene.
bool leave_out_runs(Shrinking& shrinking, const std::function<std::size_t(const Scene&)>& count,
                    const LeaveOut& leave_out) {
  bool any = false;
  for (std::size_t run = count(shrinking.scene()) / 2; run >= 1; run /= 2) {
    // From the end, so that items not yet tried keep their position.
    for (std::size_t end = count(shrinking.scene()); end > 0;) {
      const std::size_t begin = end > run ? end - run : 0;
      auto candidate = leave_out(shrinking.scene(), begin, end);
      if (candidate && shrinking.offer(std::move(*candidate))) {
        any = true;
        end = std::min(begin, count(shrinking.scene()));
      } else {
        end = begin;
      }
    }
  }
  return any;
}

// The vertices of the smallest removable part of a draw: a primitive, or one vertex if primitives
// share theirs.
std::size_t vertices_of_item(const Draw& draw) {
  return is_separate(draw) ? static_cast<std::size_t>(vertices_of(kind_of(draw.primitive))) : 1;
}

// Whether everything but the vertices is equal.
bool are_alike(const Draw& a, const Draw& b) {
  Scene one;
  Scene other;
  one.draws = {a};
  other.draws = {b};
  one.draws[0].vertices.clear();
  other.draws[0].vertices.clear();
  return same_scene(one, other);
}

}  // namespace

Draw separated(const Scene& scene, std::size_t draw) {
  Draw result = scene.draws[draw];
  if (is_separate(result)) return result;
  result.primitive = separate_form(result.primitive);
  result.vertices.clear();
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    if (static_cast<std::size_t>(primitive.draw) != draw) continue;
    for (int v = 0; v < vertices_of(primitive.kind); ++v)
      result.vertices.push_back(*primitive.vertices[static_cast<std::size_t>(v)]);
  }
  return result;
}

bool keep_only_finds(Shrinking& shrinking) {
  std::set<int> found;
  for (const Disagreement* find : shrinking.finds())
    if (find->primitive >= 0) found.insert(find->primitive);
  const Scene separate = all_separated(shrinking.scene());
  const int count = static_cast<int>(primitives_of(separate).size());
  std::vector<Scene> candidates;
  for (const int one : found) candidates.push_back(only(separate, {one}));
  for (const int one : found)
    for (int other = 0; other < count; ++other)
      if (other != one) candidates.push_back(only(separate, {one, other}));
  return shrinking.offer_first_of(std::move(candidates));
}

bool leave_out_draws(Shrinking& shrinking) {
  return leave_out_runs(
      shrinking, [](const Scene& scene) { return scene.draws.size(); },
      [](const Scene& scene, std::size_t begin, std::size_t end) -> std::optional<Scene> {
        if (end - begin == scene.draws.size()) return std::nullopt;
        Scene fewer = scene;
        const auto first = fewer.draws.begin();
        fewer.draws.erase(first + static_cast<std::ptrdiff_t>(begin),
                          first + static_cast<std::ptrdiff_t>(end));
        return fewer;
      });
}

bool separate_primitives(Shrinking& shrinking) {
  bool any = shrinking.offer(all_separated(shrinking.scene()));
  for (std::size_t d = 0; d < shrinking.scene().draws.size(); ++d) {
    if (is_separate(shrinking.scene().draws[d])) continue;
    Scene candidate = shrinking.scene();
    candidate.draws[d] = separated(shrinking.scene(), d);
    any = shrinking.offer(std::move(candidate)) || any;
  }
  return any;
}

bool leave_out_primitives(Shrinking& shrinking) {
  bool any = false;
  for (std::size_t d = 0; d < shrinking.scene().draws.size(); ++d) {
    const auto count = [d](const Scene& scene) {
      return scene.draws[d].vertices.size() / vertices_of_item(scene.draws[d]);
    };
    const auto leave_out = [d](const Scene& scene, std::size_t begin,
                               std::size_t end) -> std::optional<Scene> {
      Scene fewer = scene;
      std::vector<Vertex>& vertices = fewer.draws[d].vertices;
      const std::size_t each = vertices_of_item(scene.draws[d]);
      vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(each * begin),
                     vertices.begin() + static_cast<std::ptrdiff_t>(each * end));
      if (!is_vertex_count(fewer.draws[d].primitive, vertices.size())) return std::nullopt;
      return fewer;
    };
    any = leave_out_runs(shrinking, count, leave_out) || any;
  }
  return any;
}

bool join_draws(Shrinking& shrinking) {
  bool any = false;
  for (std::size_t d = shrinking.scene().draws.size(); d-- > 1;) {
    const Scene& scene = shrinking.scene();
    const Draw& one = scene.draws[d - 1];
    const Draw& next = scene.draws[d];
    if (!is_separate(one) || !are_alike(one, next)) continue;
    Scene joined = scene;
    std::vector<Vertex>& vertices = joined.draws[d - 1].vertices;
    vertices.insert(vertices.end(), next.vertices.begin(), next.vertices.end());
    joined.draws.erase(joined.draws.begin() + static_cast<std::ptrdiff_t>(d));
    any = shrinking.offer(std::move(joined)) || any;
  }
  return any;
}

namespace {

// One axis: the target's side, and the components of a move and of a disagreement's pixel.
struct TargetAxis {
  int Target::*size;
  int Move::*move;
  int Disagreement::*place;
};
constexpr std::array kAxes{TargetAxis{&Target::width, &Move::x, &Disagreement::x},
                           TargetAxis{&Target::height, &Move::y, &Disagreement::y}};

// The columns (rows) of the finds: [first, last]. Empty if none is known.
struct Span {
  int first = INT_MAX;
  int last = 0;
};

Span span_of(const Shrinking& shrinking, const TargetAxis& axis) {
  Span span;
  for (const Disagreement* find : shrinking.finds()) {
    span.first = std::min(span.first, find->*axis.place);
    span.last = std::max(span.last, find->*axis.place);
  }
  if (span.first == INT_MAX) span = {shrinking.scene().target.*axis.size - 1, 0};
  return span;
}

// The largest power of two that is at most n; n > 0.
int power_below(int n) {
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(n)));
}

bool offer_size(Shrinking& shrinking, const TargetAxis& axis, int size) {
  Scene candidate = shrinking.scene();
  candidate.target.*axis.size = size;
  return shrinking.offer(std::move(candidate));
}

bool cut_far_side(Shrinking& shrinking, const TargetAxis& axis) {
  const auto size = [&] { return shrinking.scene().target.*axis.size; };
  const int least = span_of(shrinking, axis).last + 1;
  bool any = least < size() && offer_size(shrinking, axis, least);
  for (int less = size() > 1 ? power_below(size() - 1) : 0; less >= 1; less /= 2)
    while (size() - less >= 1 && offer_size(shrinking, axis, size() - less)) any = true;
  return any;
}

bool offer_cut(Shrinking& shrinking, const TargetAxis& axis, int less) {
  Move move;
  move.*axis.move = -less;
  auto candidate = moved_scene(shrinking.scene(), move);
  if (!candidate) return false;
  candidate->target.*axis.size -= less;
  return shrinking.offer(std::move(*candidate));
}

bool cut_near_side(Shrinking& shrinking, const TargetAxis& axis) {
  const auto room = [&] {
    return std::min(span_of(shrinking, axis).first, shrinking.scene().target.*axis.size - 1);
  };
  bool any = false;
  for (int less = room() > 0 ? power_below(room()) : 0; less >= 1; less /= 2)
    while (less <= room() && offer_cut(shrinking, axis, less)) any = true;
  return any;
}

}  // namespace

std::optional<Scene> moved_scene(const Scene& scene, Move move) {
  if (has_clip_vertices(scene.draws)) return std::nullopt;
  Scene moved = scene;
  moved.viewport.x += move.x;
  moved.viewport.y += move.y;
  for (Draw& draw : moved.draws) {
    if (draw.scissor) {
      draw.scissor->x += move.x;
      draw.scissor->y += move.y;
    }
    for (Vertex& vertex : draw.vertices) {
      vertex.position.x = vertex.position.x + Fixed::from_integer(move.x);
      vertex.position.y = vertex.position.y + Fixed::from_integer(move.y);
    }
  }
  return moved;
}

bool crop_target(Shrinking& shrinking) {
  bool any = false;
  for (const TargetAxis& axis : kAxes) {
    any = cut_far_side(shrinking, axis) || any;
    any = cut_near_side(shrinking, axis) || any;
  }
  return any;
}

bool move_to_origin(Shrinking& shrinking) {
  bool any = false;
  for (const TargetAxis& axis : kAxes)
    for (int distance = 1 << 12; distance >= 1; distance /= 2)
      for (const int signed_distance : {-distance, distance}) {
        Move move;
        move.*axis.move = signed_distance;
        auto candidate = moved_scene(shrinking.scene(), move);
        any = (candidate && shrinking.offer(std::move(*candidate))) || any;
      }
  return any;
}

}  // namespace edgecase
