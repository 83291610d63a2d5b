// SPDX-License-Identifier: MIT
#include "search/target_steps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <utility>

#include "casefile/scene/viewport.h"

namespace edgecase {
namespace {

// Along one axis: which side of the target, and which part of a move and of a find's place.
struct TargetAxis {
  int Target::*size;
  int Move::*move;
  int Disagreement::*place;
};
constexpr std::array kAxes{TargetAxis{&Target::width, &Move::x, &Disagreement::x},
                           TargetAxis{&Target::height, &Move::y, &Disagreement::y}};

// Columns (rows) that finds lie in: [first, last]. Where none is told, any may be the one.
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

// The largest power of two that is not above n; n > 0.
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
