// SPDX-License-Identifier: MIT
#include "model/clipped_line.h"

#include <algorithm>

namespace edgecase {
namespace {

// The coordinate, between -w and w, that the viewport maps to a window coordinate, times w.
Rational unmapped(Fixed window, int low, int size, const Rational& w) {
  const Rational pixels = Rational(window.raw()) / Fixed::kOne - low;
  return (2 * pixels / size - 1) * w;
}

Rational mapped(const Rational& coordinate, const Rational& w, int low, int size) {
  return low + Rational(size) * (coordinate / w + 1) / 2;
}

// Keeps the part of the line in which the linear function from `a` to `b` is not negative.
void keep_inside(const Rational& a, const Rational& b, VisiblePart& part) {
  if (a >= 0 && b >= 0) return;
  if (a < 0 && b < 0) {
    part.to = -1;
    return;
  }
  const Rational crossing = a / (a - b);
  if (a < 0)
    part.from = std::max(part.from, crossing);
  else
    part.to = std::min(part.to, crossing);
}

}  // namespace

RationalClip rational_clip(const Vertex& vertex, const Viewport& viewport) {
  if (vertex.clip)
    return {rational_of(vertex.clip->x), rational_of(vertex.clip->y), rational_of(vertex.clip->z),
            rational_of(vertex.clip->w)};
  const Rational w = rational_of(vertex.w);
  return {unmapped(vertex.position.x, viewport.x, viewport.width, w),
          unmapped(vertex.position.y, viewport.y, viewport.height, w),
          rational_of(vertex.z.to_double()) * w, w};
}

RationalClip between(const RationalClip& from, const RationalClip& to, const Rational& part) {
  const auto mixed = [&](const Rational& a, const Rational& b) {
    return Rational(a + (b - a) * part);
  };
  return {mixed(from.x, to.x), mixed(from.y, to.y), mixed(from.z, to.z), mixed(from.w, to.w)};
}

namespace {

VisiblePart part_inside(const RationalClip& from, const RationalClip& to, bool sides) {
  VisiblePart part;
  const auto clip_at = [&](const Rational RationalClip::*axis) {
    keep_inside(from.w + from.*axis, to.w + to.*axis, part);
    keep_inside(from.w - from.*axis, to.w - to.*axis, part);
  };
  clip_at(&RationalClip::z);
  if (sides) {
    clip_at(&RationalClip::x);
    clip_at(&RationalClip::y);
  }
  return part;
}

}  // namespace

bool is_partly_inside(const RationalClip& from, const RationalClip& to, bool sides) {
  const VisiblePart part = part_inside(from, to, sides);
  return part.from < part.to;
}

std::optional<VisiblePart> visible_part(const RationalClip& from, const RationalClip& to,
                                        bool sides) {
  VisiblePart part = part_inside(from, to, sides);
  if (part.from >= part.to) return std::nullopt;
  // The eye itself, where all four coordinates are 0, has no position in the window.
  if (between(from, to, part.from).w <= 0 || between(from, to, part.to).w <= 0) return std::nullopt;
  return part;
}

std::optional<HomogeneousPoint> window_place(const RationalClip& clip, const Viewport& viewport) {
  const Rational x = mapped(clip.x, clip.w, viewport.x, viewport.width);
  const Rational y = mapped(clip.y, clip.w, viewport.y, viewport.height);
  const Integer w = boost::multiprecision::lcm(denominator(x), denominator(y));
  if (w > Integer(1) << 32) return std::nullopt;
  const auto times_w = [&](const Rational& value) {
    return static_cast<std::int64_t>(numerator(Rational(value * w)));
  };
  return HomogeneousPoint{times_w(x), times_w(y), static_cast<std::int64_t>(w)};
}

}  // namespace edgecase
