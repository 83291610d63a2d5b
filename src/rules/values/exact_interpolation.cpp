// SPDX-License-Identifier: MIT
#include "rules/values/exact_interpolation.h"

#include <algorithm>

#include "rules/values/rational_interpolation.h"

namespace edgecase {
namespace {

using Weights = WeightsOf<Interval>;

bool is_small(Int128 value) {
  constexpr Int128 kLimit = Int128{1} << 62;
  return -kLimit < value && value < kLimit;
}

// a b + c d. Factors below 2^62 are multiplied as integers, so nothing is lost if the two products
// nearly cancel.
Interval sum_of_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  if (is_small(a) && is_small(b) && is_small(c) && is_small(d)) return interval_of(a * b + c * d);
  return interval_of(a) * interval_of(b) + interval_of(c) * interval_of(d);
}

// A point's distance from `from`, times both denominators.
struct Difference {
  Int128 x;
  Int128 y;
};

Difference difference(const HomogeneousPoint& to, const HomogeneousPoint& from) {
  return {Int128{to.x} * from.w - Int128{from.x} * to.w,
          Int128{to.y} * from.w - Int128{from.y} * to.w};
}

Int128 magnitude(Int128 value) {
  return value < 0 ? -value : value;
}

// With the projection: w_1 is (p - a).(b - a), times the three denominators, and the sum of both is
// |b - a|^2, times the same.
Weights line_weights(const Interpolant& f, const HomogeneousPoint& p) {
  const HomogeneousPoint& a = f.positions[0];
  const HomogeneousPoint& b = f.positions[1];
  const Difference run = difference(b, a);
  const Difference here = difference(p, a);
  const Difference rest = difference(b, p);
  if (f.line_parameter != LineParameter::projection) {
    const bool by_x = goes_by_x(f);
    const bool forward = (by_x ? run.x : run.y) > 0;
    const auto along = [&](const Difference& d) {
      return interval_of((by_x ? d.x : d.y) * (forward ? 1 : -1));
    };
    return {along(rest) * static_cast<double>(a.w), along(here) * static_cast<double>(b.w), 0};
  }
  return {sum_of_products(rest.x, run.x, rest.y, run.y) * static_cast<double>(a.w),
          sum_of_products(here.x, run.x, here.y, run.y) * static_cast<double>(b.w), 0};
}

// 1 if the triangle's vertices lie counter-clockwise, else -1.
Int128 turn_of(const Interpolant& f) {
  return cross(f.positions[0], f.positions[1], f.positions[2]) < 0 ? -1 : 1;
}

// The sum of the weights before division by w: it does not depend on the sample, and is known more
// precisely than by adding them.
Interval total_of(const Interpolant& f, const HomogeneousPoint& p) {
  const auto scale = static_cast<double>(p.w);
  if (f.kind == PrimitiveKind::triangle)
    return interval_of(magnitude(cross(f.positions[0], f.positions[1], f.positions[2]))) * scale;
  const Difference run = difference(f.positions[1], f.positions[0]);
  if (f.line_parameter != LineParameter::projection)
    return interval_of(magnitude(goes_by_x(f) ? run.x : run.y)) * scale;
  return sum_of_products(run.x, run.x, run.y, run.y) * scale;
}

// Positive inside the primitive.
Weights plain_weights(const Interpolant& f, const HomogeneousPoint& p) {
  if (f.kind == PrimitiveKind::line) return line_weights(f, p);
  const Int128 turn = turn_of(f);
  return triangle_weights<double>(f.positions,
                                  [&](const HomogeneousPoint& a, const HomogeneousPoint& b) {
                                    return interval_of(turn * cross(a, b, p));
                                  });
}

Weights weights_over_w(const Interpolant& f, const HomogeneousPoint& p) {
  return divided_by_w(kOwnOperators, plain_weights(f, p), f.w, count_of(f));
}

// Numerator and denominator of the mean.
struct Mean {
  Interval sum;
  Interval total;
  Interval value() const { return sum / total; }
};

Mean mean_by(const Weights& weights, const Interpolant& f) {
  const std::size_t count = count_of(f);
  return {weighted_sum(kOwnOperators, weights, f.values, count),
          add_weights(kOwnOperators, weights[0], weights, 1, count)};
}

// Computed again without rounding, if the interval does not determine the nearest float32 number.
Interval settled(Interval value, const Interpolant& f, Point sample, LazyRational& rational) {
  const Interval nearest = rounded_to_float(value);
  if (nearest.low == nearest.high) return value;
  const auto& exact = rational.of(f);
  if (!exact) return value;
  if (const auto quotient = exact->quotient_at(sample)) return interval_of(*quotient);
  const auto number = exact->at(sample);
  return number ? interval_of(*number) : value;
}

// The sample's point, and the one a pixel further, over the same denominator.
HomogeneousPoint next_pixel(HomogeneousPoint p, Axis axis) {
  (axis == Axis::x ? p.x : p.y) += p.w;
  return p;
}

// Weights are linear in a homogeneous point: those of a direction are their change along it. They
// sum to 0, so the first vertex's value may be subtracted from all values.
Interval linear_slope(const Interpolant& f, Axis axis) {
  const Weights steps =
      plain_weights(f, axis == Axis::x ? HomogeneousPoint{1, 0, 0} : HomogeneousPoint{0, 1, 0});
  return slope_sum(kOwnOperators, steps, f.values, f.values[0], 1, count_of(f)) /
         total_of(f, {0, 0, 1});
}

}  // namespace

Interval interpolate_exact(const Interpolant& f, Point sample) {
  return ExactPlace(sample).value(f);
}

Interval ExactPlace::value(const Interpolant& f) const {
  if (f.kind == PrimitiveKind::point || is_constant(f)) return f.values[0];
  if (!has_extent(f)) return Interval::everything();
  Mean mean = mean_by(weights_of(f), f);
  if (!has_perspective(f)) mean.total = total_of(f);
  LazyRational rational;
  return settled(mean.value(), f, sample_, rational);
}

bool ExactPlace::has_extent(const Interpolant& f) const {
  if (!has_extent_) has_extent_ = edgecase::has_extent(f);
  return *has_extent_;
}

const ExactPlace::Weights& ExactPlace::weights_of(const Interpolant& f) const {
  if (!plain_) plain_ = plain_weights(f, homogeneous(sample_));
  if (!has_perspective(f)) return *plain_;
  if (!over_w_) over_w_ = divided_by_w(kOwnOperators, *plain_, f.w, count_of(f));
  return *over_w_;
}

const Interval& ExactPlace::total_of(const Interpolant& f) const {
  if (!total_) total_ = edgecase::total_of(f, homogeneous(sample_));
  return *total_;
}

// Determinants are linear in the sample: from pixel to pixel they grow by one number.
const ExactRun::Weights& ExactRun::weights_of(const Interpolant& f) {
  if (!plain_) {
    const HomogeneousPoint start = homogeneous(centre(0));
    const Int128 turn = turn_of(f);
    plain_ = triangle_weights<double>(
        f.positions, [&](const HomogeneousPoint& a, const HomogeneousPoint& b) {
          const Int128 step = turn * cross(a, b, {Fixed::kOne, 0, 0});
          Int128 side = turn * cross(a, b, start);
          Lanes sides;
          for (std::size_t pixel = 0; pixel < count_; ++pixel, side += step)
            sides.set(pixel, interval_of(side));
          return sides;
        });
  }
  if (!has_perspective(f)) return *plain_;
  if (!over_w_) over_w_ = divided_by_w(kOwnOperators, *plain_, f.w, 3);
  return *over_w_;
}

ExactRun::Lanes ExactRun::means_of(const Interpolant& f) {
  const Weights& weights = weights_of(f);
  const Lanes sum = weighted_sum(kOwnOperators, weights, f.values, 3);
  if (has_perspective(f)) return sum / add_weights(kOwnOperators, weights[0], weights, 1, 3);
  return sum / total_of(f, homogeneous(centre(0)));
}

Point ExactRun::centre(std::size_t pixel) const {
  return pixel_centre(first_.x + static_cast<int>(pixel), first_.y);
}

void ExactRun::values(const Interpolant& f, LazyRational& rational, std::span<Interval> results) {
  if (count_ == 1) {
    if (!alone_) alone_.emplace(centre(0));
    results[0] = alone_->value(f);
    return;
  }
  if (f.kind == PrimitiveKind::triangle && !is_constant(f) && has_extent(f)) {
    const Lanes means = means_of(f);
    for (std::size_t pixel = 0; pixel < count_; ++pixel)
      results[pixel] = settled(means[pixel], f, centre(pixel), rational);
    return;
  }
  for (std::size_t pixel = 0; pixel < count_; ++pixel)
    results[pixel] = interpolate_exact(f, centre(pixel));
}

Interval interpolate_exact(const Interpolant& f, Point sample, Point w_place) {
  if (sample == w_place || !has_perspective(f)) return interpolate_exact(f, sample);
  return interpolate_exact(over_w(f), sample) / interpolate_exact(inverse_w(f), w_place);
}

// With N / D the mean, its derivative is (N' - (N / D) D') / D. Weights are linear in the sample,
// so N' and D' are differences over one pixel, exactly.
Interval differentiate_exact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point || is_constant(f)) return 0;
  if (!has_extent(f)) return Interval::everything();
  if (is_linear(f)) return linear_slope(f, axis);
  const HomogeneousPoint p = homogeneous(sample);
  const Weights here = weights_over_w(f, p);
  Weights growth = weights_over_w(f, next_pixel(p, axis));
  for (std::size_t i = 0; i < count_of(f); ++i) growth[i] = growth[i] - here[i];
  const Mean mean = mean_by(here, f);
  // N' - v D' as one sum over the vertices, so that values cancel and not products.
  return slope_sum(kOwnOperators, growth, f.values, mean.value(), 0, count_of(f)) / mean.total;
}

}  // namespace edgecase
