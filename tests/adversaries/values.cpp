// SPDX-License-Identifier: MIT
#include "tests/adversaries/values.h"

#include <algorithm>
#include <cmath>

namespace edgecase::adversary {
namespace {

Real pixels(std::int64_t raw) {
  return static_cast<double>(raw) / kPixel;
}

struct Spot {
  Real x, y;
};

// A(lmn), twice over, by what is nearest to the last one.
Real area(Spot l, Spot m, Spot n) {
  return (l.x - n.x) * (m.y - n.y) - (l.y - n.y) * (m.x - n.x);
}
Spot spot(const Corner& corner) {
  return {corner.x, corner.y};
}

std::array<Real, 3> depths(const Piece& piece) {
  return {piece.corners[0].depth, piece.corners[1].depth, piece.corners[2].depth};
}

// What a number grows by along x and y in a triangle's plane.
Spot slopes(const Piece& piece, const std::array<Real, 3>& n) {
  const auto& [a, b, c] = piece.corners;
  const Real ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const Real whole = ux * vy - uy * vx, du = n[1] - n[0], dv = n[2] - n[0];
  return {(du * vy - dv * uy) / whole, (dv * ux - du * vx) / whole};
}

bool is_wide_enough(const Piece& piece) {
  const auto& c = piece.corners;
  return area(spot(c[0]), spot(c[1]), spot(c[2])).value != 0;
}

}  // namespace

Values::Weights Values::weights(const Shape& shape, const Piece& piece, Place place) const {
  const auto& c = piece.corners;
  const Spot p{pixels(place.x), pixels(place.y)};
  if (shape.primitive->kind == PrimitiveKind::point) return {1.0, 0.0, 0.0};
  if (shape.primitive->kind == PrimitiveKind::line) {  // equation 14.5
    const Real dx = c[1].x - c[0].x, dy = c[1].y - c[0].y;
    const Real t = ((p.x - c[0].x) * dx + (p.y - c[0].y) * dy) / (dx * dx + dy * dy);
    return {1.0 - t, t, 0.0};
  }
  const Real whole = area(spot(c[1]), spot(c[2]), spot(c[0]));
  const Real first = area(spot(c[1]), spot(c[2]), p) / whole;
  const Real second = area(spot(c[2]), spot(c[0]), p) / whole;
  // 14.6.1: the shares of a polygon with more than three edges "sum to one". A piece of it may be
  // so thin that three areas would not.
  const bool is_a_part = shape.pieces.size() > 1;
  return {first, second,
          is_a_part ? 1.0 - first - second : area(spot(c[0]), spot(c[1]), p) / whole};
}

Real Values::mean(const Shape& shape, const Piece& piece, Place place, const Weights& w,
                  std::array<Real, 3> n) const {
  if (shape.primitive->kind == PrimitiveKind::point) return n[0];
  const bool is_line = shape.primitive->kind == PrimitiveKind::line;
  if (freedoms_.formula == Formula::sums || (is_line && freedoms_.formula == Formula::planes))
    return is_line ? w[0] * n[0] + w[1] * n[1] : w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
  if (is_line) return n[0] + w[1] * (n[1] - n[0]);
  if (freedoms_.formula == Formula::differences)
    return n[0] + w[1] * (n[1] - n[0]) + w[2] * (n[2] - n[0]);
  const Spot slope = slopes(piece, n);
  return n[0] + (pixels(place.x) - piece.corners[0].x) * slope.x +
         (pixels(place.y) - piece.corners[0].y) * slope.y;
}

Values4 Values::attribute(const Shape& shape, const Piece& piece, Place place) const {
  const Interpolation way = shape.draw->interpolation;
  const auto& c = piece.corners;
  Values4 result = shape.provoking;
  if (way == Interpolation::flat) {
    if (freedoms_.crime == "flat by one unit")
      for (double& n : result) n = static_cast<double>(std::nextafter(static_cast<float>(n), 9e9F));
    return result;
  }
  if (shape.primitive->kind == PrimitiveKind::point) {
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = way == Interpolation::noperspective || c[0].clip[3] == 1
                      ? c[0].value[i]
                      : (Real(c[0].value[i]) / c[0].clip[3] * c[0].clip[3]).value;
    return result;
  }
  seed_errors(hash(hash(static_cast<std::uint64_t>(place.x), static_cast<std::uint64_t>(place.y)),
                   static_cast<std::uint64_t>(shape.primitive->index)));
  Place at = place;
  if (freedoms_.crime == "values a quarter pixel off") at.x += kPixel / 4;
  const Weights w = weights(shape, piece, at);
  const bool smooth = way == Interpolation::smooth;
  const auto over_w = [&](std::size_t k, Real n) { return smooth ? n / c[k].clip[3] : n; };
  const std::size_t last = shape.primitive->kind == PrimitiveKind::line ? 1 : 2;
  const Real whole =
      smooth ? mean(shape, piece, at, w, {over_w(0, 1), over_w(1, 1), over_w(last, 1)}) : Real(1);
  for (std::size_t i = 0; i < 4; ++i) {
    const Real sum =
        mean(shape, piece, at, w,
             {over_w(0, c[0].value[i]), over_w(1, c[1].value[i]), over_w(last, c[last].value[i])});
    result[i] = (smooth ? sum / whole : sum).value;
  }
  if (freedoms_.crime == "values beyond the hull") {
    for (std::size_t i = 0; i < 4; ++i) {
      const double most = std::max({c[0].value[i], c[1].value[i], c[last].value[i]});
      result[i] = most + 0.01 * std::abs(most);
    }
  }
  return result;
}

double Values::inverse_w(const Shape& shape, const Piece& piece, Place place) const {
  const auto& c = piece.corners;
  const std::size_t last = shape.primitive->kind == PrimitiveKind::triangle ? 2 : 0;
  const std::size_t second = shape.primitive->kind == PrimitiveKind::point ? 0 : 1;
  return mean(shape, piece, place, weights(shape, piece, place),
              {Real(1) / c[0].clip[3], Real(1) / c[second].clip[3], Real(1) / c[last].clip[3]})
      .value;
}

// 14.6.5: one value for the polygon.
Real Values::offset(const Shape& shape) const {
  const PolygonOffset& o = *shape.draw->polygon_offset;
  seed_errors(static_cast<std::uint64_t>(shape.primitive->index));
  double largest = 0;
  Spot slope;
  for (const Piece& piece : shape.pieces) {
    for (const Corner& corner : piece.corners) largest = std::max(largest, corner.depth.value);
    if (is_wide_enough(piece)) slope = slopes(piece, depths(piece));
  }
  const Real across = std::abs(slope.x.value), up = std::abs(slope.y.value);
  const Real m = freedoms_.offset_by_partial
                     ? Real(std::max(across.value, up.value))
                     : Real(rounded(std::sqrt((across * across + up * up).value)));
  double r = 0;
  const DepthFormat format = scene_.target.depth;
  if (format == DepthFormat::depth32f) {
    r = std::ldexp(1.0, (largest > 0 ? std::max(std::ilogb(largest), -126) : -126) - 23);
    if (freedoms_.crime == "units of half the size") r /= 2;
  } else if (format != DepthFormat::none) {
    r = std::ldexp(freedoms_.offset_unit, format == DepthFormat::depth16 ? -16 : -24);
    if (freedoms_.crime == "units of half the size") r *= 0.5 / freedoms_.offset_unit;
    if (freedoms_.crime == "units that differ" && shape.primitive->index % 2 != 0) r *= 2;
  }
  double sum = (m * static_cast<double>(o.factor) + Real(r) * static_cast<double>(o.units)).value;
  const double limit = static_cast<double>(o.clamp);
  if (limit > 0) sum = std::min(sum, limit);
  if (limit < 0) sum = std::max(sum, limit);
  return sum;
}

double Values::depth(const Shape& shape, const Piece& piece, Place place) const {
  const Real added = shape.draw->polygon_offset && shape.primitive->kind == PrimitiveKind::triangle
                         ? offset(shape)
                         : Real(0);
  seed_errors(
      hash(hash(static_cast<std::uint64_t>(place.x), static_cast<std::uint64_t>(place.y)), 7));
  const Real plain = mean(shape, piece, place, weights(shape, piece, place), depths(piece));
  if (!shape.draw->polygon_offset || shape.primitive->kind != PrimitiveKind::triangle)
    return plain.value;
  const double sum = (plain + added).value;
  return freedoms_.tells_clamped_depths ? std::clamp(sum, 0.0, 1.0) : sum;
}

std::array<Values4, kDerivatives> Values::derivatives(const Shape& shape, const Piece& piece,
                                                      PixelPosition pixel) const {
  const auto difference = [&](Place from, Place to, double distance) {
    const Values4 low = attribute(shape, piece, from), high = attribute(shape, piece, to);
    Values4 made;
    for (std::size_t i = 0; i < 4; ++i) made[i] = (Real(high[i]) - Real(low[i])).value / distance;
    return made;
  };
  const auto centre = [](int n) { return n * kPixel + kPixel / 2; };
  if (freedoms_.analytic) {
    const std::int64_t off = kPixel / 64;
    const Place at{centre(pixel.x), centre(pixel.y)};
    const Values4 along_x = difference({at.x - off, at.y}, {at.x + off, at.y}, 1.0 / 32);
    const Values4 along_y = difference({at.x, at.y - off}, {at.x, at.y + off}, 1.0 / 32);
    return {along_x, along_y, along_x, along_y, along_x, along_y};
  }
  int left = pixel.x - ((pixel.x + freedoms_.quad_x) & 1),
      low = pixel.y - ((pixel.y + freedoms_.quad_y) & 1);
  int row = pixel.y, column = pixel.x;
  if (freedoms_.crime == "derivatives two pixels away") left += 2, low += 2, row += 2, column += 2;
  const auto along_x = [&](int y) {
    return difference({centre(left), centre(y)}, {centre(left + 1), centre(y)}, 1);
  };
  const auto along_y = [&](int x) {
    return difference({centre(x), centre(low)}, {centre(x), centre(low + 1)}, 1);
  };
  const Values4 fine_x = along_x(row), fine_y = along_y(column);
  const Values4 coarse_x = along_x(low), coarse_y = along_y(left);
  return {freedoms_.coarse_plain ? coarse_x : fine_x,
          freedoms_.coarse_plain ? coarse_y : fine_y,
          fine_x,
          fine_y,
          coarse_x,
          coarse_y};
}

}  // namespace edgecase::adversary
