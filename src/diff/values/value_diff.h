// SPDX-License-Identifier: MIT
//
// Values: what fragments carry and what ends up in pixels, held against what is exact under a
// policy and against what the specification permits (rulings 8 to 11 and 16 to 18), which knows no
// policy. Coverage is not looked at: a fragment that exact does not have is compared with the
// attribute's value at its place all the same.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/pixel.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/textures/level_of_detail.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

// What is known of one primitive's attributes.
struct PrimitiveValues {
  PrimitiveAttributes chosen;  // under the policy
  PrimitiveAttributes lawful;  // under OpenGL's own choices
  // The lawful depth and 1/w with all that the vertices' own may be off by, the depth with every
  // polygon offset that is permitted; before it is clamped.
  Interpolant permitted_depth;
  Interpolant permitted_inverse_w;
  bool differ = false;  // the policy interpolates otherwise than OpenGL does
  double reach = 0;     // pixels that a vertex may have moved: rulings 4 and 15
  // A triangle that clipping makes a polygon of more than three edges: what its fragments carry is
  // some mean of what the polygon's vertices do (14.6.1).
  bool is_polygon = false;

  // Of the lawful attributes; worked out when they are first asked for.
  const MovedVertices& moved() const;
  mutable std::optional<MovedVertices> known_moved;
};

// What the comparison of values needs of a case.
class ValueContext {
 public:
  // All must outlive the context. `bits` as in ruling 4; `reported`: where the renderer says that
  // samples lie.
  ValueContext(const Scene& scene, std::span<const ScenePrimitive> primitives,
               const RuleChoices& choices, int bits, Latitude latitude,
               const SamplePositions& reported = {});

  // How often the renderer runs its shader, where that is not as the policy has it.
  void follow(ShadingRate rate) { rate_ = rate; }
  // What the unit of polygon offsets may be of a fixed-point buffer, where the renderer's depths
  // tell more than permitted_fixed_unit(); before values of primitives are asked for.
  void follow_fixed_unit(Interval unit) { fixed_unit_ = unit; }
  // What the renderer says that bounds its levels of detail.
  void follow_limits(const LookupLimits& limits) { lookup_limits_ = limits; }
  const LookupLimits& lookup_limits() const { return lookup_limits_; }

  const Scene& scene;
  std::span<const ScenePrimitive> primitives;
  const RuleChoices& choices;
  Latitude latitude;

  // As in ruling 4.
  int bits() const { return bits_; }

  // Where within a pixel of the target a sample lies, as the renderer has it.
  Point sample_position(int sample) const { return positions_[static_cast<std::size_t>(sample)]; }
  const SamplePositions& sample_positions() const { return positions_; }

  // Where in the window exact evaluates what a fragment carries: its attributes, its depth, and
  // gl_FragCoord.xy itself. The pixel's centre, unless the draw is multisampled; attributes of wide
  // lines elsewhere (attribute_place).
  Point place_of(const Fragment& fragment, const LocationChoice& choice) const;
  Point depth_place_of(const Fragment& fragment, const LocationChoice& choice) const;
  Point coordinates_of(const Fragment& fragment) const;
  // Corners of the regions in which the specification lets attributes, and gl_FragCoord, be
  // evaluated on a multisampled target; empty on one of one sample, where it knows one place alone.
  std::vector<Point> permitted_places(const Fragment& fragment) const;
  std::vector<Point> permitted_coordinates(const Fragment& fragment) const;

  const ScenePrimitive& primitive_of(const Fragment& fragment) const;
  // Worked out when a primitive is first asked for.
  const PrimitiveValues& values_of(const Fragment& fragment) const;

 private:
  std::optional<Invocation> invocation_of(const Fragment& fragment) const;

  int bits_;
  ShadingRate rate_;
  Interval fixed_unit_;
  LookupLimits lookup_limits_;
  SamplePositions positions_;
  // Worked out for a primitive when it is first asked for; some kilobytes each.
  mutable std::vector<std::unique_ptr<PrimitiveValues>> values_;
};

// Each appends disagreements (beyond what is permitted) and aggregates (inside it) to `result`.

// Colours and depths, as the renderer tells them per fragment.
void compare_fragment_values(const ValueContext& context, const Rendering& rendered,
                             Result& result);

// gl_FragCoord and derivatives of the colour, where they were asked for and told.
void compare_coordinates(const ValueContext& context, const Rendering& rendered, Result& result);
void compare_derivatives(const ValueContext& context, const Rendering& rendered, Result& result);

// The depth buffer, of multisampled targets sample by sample, against the last fragment that the
// renderer says it drew there.
void compare_depths(const ValueContext& context, const Rendering& rendered, Result& result);

// The policy's choices, with OpenGL's own on attributes.
RuleChoices lawful_choices(const RuleChoices& chosen);

// Every depth that a primitive may have at a place of the window, its vertices moved and its
// polygon offset as far as the specification leaves that open.
Interval depth_permitted_at(const PrimitiveValues& values, Point place);

// `permitted`, of a component of the colour, with what it may be on a polygon: anything between the
// least and the greatest of the triangle's vertices, of which the polygon's own are means.
Interval with_means(Interval permitted, const ScenePrimitive& primitive,
                    const PrimitiveValues& values, std::size_t component);
// The same of 1/w, between the least and the greatest of the polygon's own vertices, which need not
// be the triangle's.
Interval with_means_of_inverse_w(Interval permitted, const ScenePrimitive& primitive,
                                 const PrimitiveValues& values);
// All depths of a polygon's vertices, in the window: ruling 44 contests those of them that are not
// on its plane. Nothing but `permitted` where the primitive is no such polygon.
Interval with_means_of_depth(Interval permitted, const ScenePrimitive& primitive,
                             const PrimitiveValues& values);
inline constexpr int kRulingOnPolygonDepth = 44;

// `permitted`, of a value that exact computes as the specification has it, widened by what is
// exact, rounded to float32: what is exact is never accused. It is left out where a renderer tells
// of a fragment that the primitive cannot have, whose place in the primitive is nowhere.
Interval holding(Interval permitted, double exact);

// What is permitted wherever in a pixel of a multisampled target the attribute is evaluated:
// corners of a convex region, at least one. A quotient of linear functions has its extremes at
// corners, unless its denominator passes through 0 between them.
Interval permitted_within(const Interpolant& interpolant, const Interpolant& inverse_w,
                          std::span<const PermittedPlace> corners);

// A value disagreement at a pixel, not legal, with the pixel's centre marked; of no sample until
// one is named. primitive -1: the pixel.
Disagreement value_disagreement(PixelPosition pixel, int primitive, RuleId rule, int ruling);

// Distance between neighbouring float32 values at `value`.
double float_ulp(double value);
// How far two numbers lie apart, in units of the last place of the larger: beside a zero crossing,
// where the exact value has hardly any place of its own, at most 2^24; that, too, where one of them
// is infinite.
double error_in_ulp(double exact, double rendered);
// Largest less least of the values at the vertices; 0 where float32 could hardly tell them apart.
double range_of(const Interpolant& interpolant);

// Counts the values of one attribute that differ inside the permitted range, and keeps the worst.
class ValueAggregator {
 public:
  ValueAggregator(std::string attribute, RuleId rule, int ruling, Cause cause = {});

  const std::string& attribute() const { return aggregate_.attribute; }

  // A place with so many components is compared, or several such places.
  void count_compared(std::size_t components, std::size_t places = 1);
  // As many are compared as of another one, which a part of the values was taken from.
  void count_as(const ValueAggregator& whole);
  // Errors of one place: add_error for each component that differs, then add_place once.
  // `range`: of the attribute, for the relative error.
  struct Error {
    int component = 0;
    double exact = 0;
    double rendered = 0;
    double ulp = 0;
    double range = 0;
  };
  void add_error(ValueAggregate::Place place, const Error& error);
  void add_place(ValueAggregate::Place place) { aggregate_.differing.push_back(place); }
  // Appends the aggregate to the result, if anything was compared: what is compared pass by pass is
  // counted in whole. compare() leaves out those of which nothing differs.
  void flush(Result& result);

 private:
  ValueAggregate aggregate_;
  double ulp_sum_ = 0;
};

// ------------------------------------------------------------------------- values that equal exact
//
// Answers that hold what exact holds, to the bit. Most do where colours are flat, and none of their
// values need be judged.

// Is exact drawn by OpenGL's own choices, and does the answer tell of fragments and of the target
// all that exact does, bit by bit? Then every value is correct, and so permitted. Said only of what
// is drawn at one go with one sample each, without textures, fragment operations and polygon
// offset, and of answers without details: elsewhere false, which says nothing.
bool has_exact_values(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
                      const Rendering& rendered);

}  // namespace edgecase
