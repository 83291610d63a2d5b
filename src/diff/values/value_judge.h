// SPDX-License-Identifier: MIT
//
// The colour, depth and gl_FragCoord that one fragment should have under the policy, and all that
// the specification permits (rulings 9, 13, 17, 29 and 46).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "diff/values/value_diff.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/values/exact_interpolation.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

// One component of a reported value, with the exact and the permitted values.
struct ValueComponent {
  double exact = 0;    // the double nearest to the exact value
  Interval permitted;  // float32 values that the specification allows
  double rendered = 0;
  bool may_be_of_column = false;  // a value that another fragment of a wide line's column may have
  bool may_be_mean = false;       // of what the vertices of a clipped polygon carry
  double range = 0;               // of the attribute over the vertices; unused for a correct one

  // Equal to exact's own answer. Halfway between two float32 numbers the other one is reported,
  // half a unit off.
  bool is_correct() const { return to_float(rendered) == to_float(exact); }
  // NaN and infinity are never permitted: a primitive has a number everywhere.
  bool is_permitted() const {
    return std::isfinite(rendered) && permitted.contains(to_float(rendered));
  }
};

// From the first to the last fragment of a line's column, pixels; 0 without columns.
inline Fixed height_of_column(const ScenePrimitive& primitive, const Target& target) {
  if (primitive.kind != PrimitiveKind::line || is_multisampled(*primitive.state, target)) return {};
  return Fixed::from_integer(rounded_width(primitive.state->line_width) - 1);
}

// The permitted values at the centre of a pixel of a wide line: each fragment of a column may have
// the value of its own centre, or that of the adjusted line at the column's lowest fragment, which
// is the line's own in the middle of the column: at most (width - 1)/2 away (ruling 13).
// `across`: how far, pixels.
inline Interval permitted_across(const Interpolant& interpolant, const MovedVertices& vertices,
                                 const PermittedPlace& place, Point sample, Fixed across) {
  Interval result = place.value(interpolant);
  if (interpolant.kind != PrimitiveKind::line || across == Fixed()) return result;
  const bool x_major = is_x_major(interpolant);
  for (const Fixed offset : {across, -across}) {
    Point moved = sample;
    (x_major ? moved.y : moved.x) = (x_major ? moved.y : moved.x) + offset;
    result = hull(result, PermittedPlace(vertices, moved).value(interpolant));
  }
  return result;
}

// A value under the policy, the same as the specification has it, and its location.
struct JudgedValue {
  const Interpolant& chosen;
  const Interpolant& lawful;
  Point place;                                 // where exact evaluates it
  const std::vector<PermittedPlace>& corners;  // of the region where it may be evaluated, or none
  bool is_depth = false;                       // clamped if it has a polygon offset
};

// True if exact evaluates attributes where the specification lets them be evaluated.
inline bool has_lawful_places(const LocationChoice& choice) {
  return choice.plain != PlainLocation::half_pixel_off &&
         choice.centroid != CentroidLocation::centre && choice.depth == DepthLocation::at_sample;
}

// Judges one attribute of one fragment, under the policy and under OpenGL.
class ValueJudge {
 public:
  // `drawn`: the same fragment as exact drew it, which settles most values; none: unknown.
  ValueJudge(const ValueContext& context, const Fragment& fragment,
             const std::optional<Fragment>& drawn)
      : primitive_(context.primitive_of(fragment)),
        values_(context.values_of(fragment)),
        place_(pixel_centre(fragment.x, fragment.y)),
        depth_place_(place_),
        pixel_{fragment.x, fragment.y},
        column_(height_of_column(primitive_, context.scene.target)),
        depth_is_zero_(fragment_depth_is_zero(primitive_.state->multisampling,
                                              context.choices.values.locations)),
        lawful_(!values_.differ && has_lawful_places(context.choices.values.locations)),
        forgiving_(context.latitude == Latitude::none) {
    if (context.scene.target.samples > 1 || column_ != Fixed())
      place_ = context.place_of(fragment, context.choices.values.locations);
    else
      drawn_ = drawn;
    if (context.scene.target.samples == 1) return;
    depth_place_ = context.depth_place_of(fragment, context.choices.values.locations);
    for (const Point corner : context.permitted_places(fragment))
      corners_.emplace_back(values_.moved(), corner);
    for (const Point corner : context.permitted_coordinates(fragment))
      depth_corners_.emplace_back(values_.moved(), corner);
    // An invocation for several samples is at none of them (ruling 34 judges it).
    if (is_at_sample(primitive_.state->multisampling) && !std::has_single_bit(fragment.coverage))
      lawful_ = false;
  }

  // `exact`: what question.chosen yields.
  ValueComponent component(Interval exact, const JudgedValue& question, double rendered) const {
    const double error = exact.high - exact.low;
    if (const auto known = settled(middle(exact), error, question, rendered)) return *known;
    ValueComponent result;
    result.exact = middle(exact);
    result.rendered = rendered;
    result.range = range_of(question.chosen);
    // A value that is near enough without moving any vertex needs no search over their moves.
    result.permitted = as_reported(question, inexact_at(question.place).value(question.lawful));
    if (result.is_permitted()) return result;
    result.permitted = as_reported(question, permitted(question));
    // The renderer's unit of an offset depth may differ from exact's (ruling 38).
    const bool has_own_unit = question.is_depth && values_.lawful.clamps_depth;
    if (lawful_ && !has_own_unit) result.permitted = holding(result.permitted, result.exact);
    result.may_be_of_column = !result.is_permitted() && column_ != Fixed() &&
                              as_reported(question, permitted_in_column(question.lawful, column_))
                                  .contains(to_float(rendered));
    result.may_be_mean =
        !result.is_permitted() && values_.is_polygon && !question.is_depth &&
        rounded_to_float(with_means(result.permitted, primitive_, values_, question.lawful))
            .contains(to_float(rendered));
    return result;
  }

  Point place() const { return place_; }
  Point depth_place() const { return depth_place_; }

  // True if a correct value here means correct values everywhere in the primitive, and nothing else
  // is tested.
  bool asks_alike_everywhere() const {
    return are_constant(values_.chosen) && are_constant(values_.lawful) &&
           (forgiving_ || !values_.differ);
  }

  ValueComponent color(std::size_t c, double rendered) const {
    const JudgedValue question{values_.chosen.color[c], values_.lawful.color[c], place_, corners_};
    if (drawn_ && drawn_->has_color)
      if (const auto known = settled_as_drawn(drawn_->color[c], question, rendered)) return *known;
    return component(exact_color(c), question, rendered);
  }
  ValueComponent depth(double rendered) const {
    const JudgedValue question{values_.chosen.depth, values_.permitted_depth, depth_place_,
                               depth_corners_, true};
    if (drawn_)
      if (const auto known = settled_as_drawn(drawn_->depth, question, rendered)) return *known;
    const Interval exact =
        depth_is_zero_
            ? 0
            : clamped_depth(values_.chosen, exact_at(depth_place_).value(values_.chosen.depth));
    return component(exact, question, rendered);
  }
  ValueComponent inverse_w(double rendered) const {
    return component(
        interpolate_exact(values_.chosen.inverse_w, depth_place_),
        {values_.chosen.inverse_w, values_.permitted_inverse_w, depth_place_, depth_corners_},
        rendered);
  }

 private:
  // A value whose exact number shows already that it is permitted. `error`: at most that of the
  // number, absolute.
  std::optional<ValueComponent> settled(double exact, double error, const JudgedValue& question,
                                        double rendered) const {
    ValueComponent result{exact, Interval(to_float(rendered)), rendered};
    // Under a policy without latitude, a correct value is permitted, whatever its formula.
    if (result.is_correct() && (forgiving_ || !values_.differ)) return result;
    if (!is_one_rounding_off(exact, error, question, rendered)) return std::nullopt;
    result.range = range_of(question.chosen);
    return result;
  }

  // The same for a number that exact drew. It errs by at most 2^-48 of the largest value at a
  // vertex (raster/attributes.h); 2^-40 of it is on the safe side.
  std::optional<ValueComponent> settled_as_drawn(double drawn, const JudgedValue& question,
                                                 double rendered) const {
    return settled(drawn, 0x1p-40 * largest_value(question.chosen), question, rendered);
  }

  // True for a value that is permitted because the last operation alone may err so far: whatever is
  // permitted holds a part of 10^-5 of the exact value on either side.
  bool is_one_rounding_off(double exact, double error, const JudgedValue& question,
                           double rendered) const {
    constexpr double kPart = 0.9 * kInexact.relative;
    const bool has_last_operation = !values_.differ && question.lawful.kind != PrimitiveKind::point;
    if (!has_last_operation || (question.is_depth && values_.lawful.clamps_depth)) return false;
    const double at_most = std::fabs(exact) * kPart;
    return error <= at_most * 0.01 && std::fabs(to_float(rendered) - exact) <= at_most;
  }

  Interval exact_color(std::size_t c) const {
    if (values_.chosen.w_of_centre) return color_exact(values_.chosen, c, place_, pixel_);
    return exact_at(place_).value(values_.chosen.color[c]);
  }

  // The float32 numbers that a fragment may report for an interpolated value.
  Interval as_reported(const JudgedValue& question, Interval interpolated) const {
    return rounded_to_float(question.is_depth ? reported_depth(interpolated) : interpolated);
  }

  // Depths with a polygon offset are clamped. Without one, a depth beyond 0 to 1, where a
  // fragment's centre lies outside the primitive, may be clamped or not: 14.6.5 is about offset
  // depths alone.
  Interval reported_depth(Interval depth) const {
    if (values_.lawful.clamps_depth) return clamped_depth(values_.lawful, depth);
    return hull(depth, {std::clamp(depth.low, 0.0, 1.0), std::clamp(depth.high, 0.0, 1.0)});
  }

  // For a value of a whole pixel or column, from all locations where it may be evaluated.
  Interval permitted(const JudgedValue& question) const {
    const auto& [chosen, lawful, place, corners, is_depth] = question;
    if (corners.empty() && column_ == Fixed()) return permitted_at(place).value(lawful);
    const Interval across = permitted_in_column(lawful, Fixed::from_raw(column_.raw() / 2));
    if (corners.empty()) return across;
    const Interval within = permitted_within(lawful, values_.lawful.inverse_w, corners);
    return column_ == Fixed() ? within : hull(within, across);
  }

  // The values of a wide line up to this distance from the pixel's centre along its minor axis.
  Interval permitted_in_column(const Interpolant& lawful, Fixed across) const {
    const Point centre = pixel_centre(pixel_.x, pixel_.y);
    return permitted_across(lawful, values_.moved(), permitted_at(centre), centre, across);
  }

  // The part that the components of a colour share is computed once.
  const PermittedPlace& permitted_at(Point place) const {
    if (!known_ || known_->first != place)
      known_.emplace(place, PermittedPlace(values_.moved(), place));
    return known_->second;
  }

  // The same for exact values, and for lawful attributes without moved vertices.
  const ExactPlace& exact_at(Point place) const {
    if (!exact_ || exact_->first != place) exact_.emplace(place, ExactPlace(place));
    return exact_->second;
  }
  const InexactPlace& inexact_at(Point place) const {
    if (!unmoved_ || unmoved_->first != place) unmoved_.emplace(place, InexactPlace(place));
    return unmoved_->second;
  }

  const ScenePrimitive& primitive_;
  const PrimitiveValues& values_;
  Point place_;        // of the colour
  Point depth_place_;  // of gl_FragCoord.z and gl_FragCoord.w
  PixelPosition pixel_;
  Fixed column_;  // height, of a wide line's
  std::optional<Fragment> drawn_;
  bool depth_is_zero_;
  bool lawful_;  // exact evaluates as the specification does
  // Of the regions where the colour, and gl_FragCoord, may be evaluated.
  std::vector<PermittedPlace> corners_;
  std::vector<PermittedPlace> depth_corners_;
  mutable std::optional<std::pair<Point, PermittedPlace>> known_;
  mutable std::optional<std::pair<Point, ExactPlace>> exact_;
  mutable std::optional<std::pair<Point, InexactPlace>> unmoved_;
  bool forgiving_;
};

}  // namespace edgecase
