// SPDX-License-Identifier: MIT
//
// Values: what fragments carry and what pixels hold, compared with exact under a policy and with
// what the specification permits (rulings 8 to 11 and 16 to 18), whatever the policy. Coverage
// plays no part: a fragment that exact does not have is still compared with the attribute's value
// at its location.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/values/pixel_truth.h"
#include "exact/fixed.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/textures/level_of_detail.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

// The attributes of one primitive.
struct PrimitiveValues {
  PrimitiveAttributes chosen;  // under the policy
  PrimitiveAttributes lawful;  // under OpenGL's own choices
  // The lawful depth and 1/w with all errors that the vertices' own may have, the depth with every
  // permitted polygon offset; before clamping.
  Interpolant permitted_depth;
  Interpolant permitted_inverse_w;
  bool differ = false;  // the policy interpolates differently from OpenGL
  double reach = 0;     // how far a vertex may have moved, pixels: rulings 4 and 15
  // A triangle that clipping turns into a polygon of more than three edges: its fragments carry
  // some mean of the values of the polygon's vertices (14.6.1).
  bool is_polygon = false;

  // Of the lawful attributes; computed on demand.
  const MovedVertices& moved() const;
  mutable std::optional<MovedVertices> known_moved;
  mutable std::vector<PermittedPlace> corners = {};  // of the polygon; found at the first question
};

// A case, as the comparison of values needs it.
class ValueContext {
 public:
  // Everything referred to must outlive the context. `bits` as in ruling 4; `reported`: sample
  // positions as the renderer reports them.
  ValueContext(const Scene& scene, std::span<const ScenePrimitive> primitives,
               const RuleChoices& choices, int bits, Latitude latitude,
               const SamplePositions& reported = {});

  // How often the renderer runs its shader, if that differs from the policy.
  void follow(ShadingRate rate) { rate_ = rate; }
  // The possible units of polygon offsets in a fixed-point buffer, if the renderer's depths show
  // more than permitted_fixed_unit(); call before values of primitives are needed.
  void follow_fixed_unit(Interval unit) { fixed_unit_ = unit; }
  // The limits that the renderer reports for its levels of detail.
  void follow_limits(const LookupLimits& limits) { lookup_limits_ = limits; }
  const LookupLimits& lookup_limits() const { return lookup_limits_; }
  // The colours of textured fragments whose colours the renderer does not tell.
  void follow_lookups(std::function<PixelTruth(const Fragment&)> looked_up) {
    looked_up_ = std::move(looked_up);
  }
  PixelTruth looked_up(const Fragment& fragment) const;
  // Of a gross fault: strays, which are fragments of `rendered` whose pixel their primitive has
  // none of in `exact`, may have any colour that they do not tell. Their coverage is judged, and to
  // bound the colours of hundreds of thousands would take most of the time.
  void leave_strays_open(const Rendering& exact, const Rendering& rendered);
  bool is_open_stray(const Fragment& fragment) const;

  const Scene& scene;
  std::span<const ScenePrimitive> primitives;
  const RuleChoices& choices;
  Latitude latitude;

  // As in ruling 4.
  int bits() const { return bits_; }

  // Where a sample lies within a pixel of the target, as the renderer reports it.
  Point sample_position(int sample) const { return positions_[static_cast<std::size_t>(sample)]; }
  const SamplePositions& sample_positions() const { return positions_; }

  // Where in the window exact evaluates what a fragment carries: its attributes, its depth, and
  // gl_FragCoord.xy itself. At the pixel's centre, unless the draw is multisampled; attributes of
  // wide lines elsewhere (attribute_place).
  Point place_of(const Fragment& fragment, const LocationChoice& choice) const;
  Point depth_place_of(const Fragment& fragment, const LocationChoice& choice) const;
  Point coordinates_of(const Fragment& fragment) const;
  // Corners of the regions where the specification lets attributes, and gl_FragCoord, be evaluated
  // on a multisampled target; empty on a target of one sample, which has a single location.
  std::vector<Point> permitted_places(const Fragment& fragment) const;
  std::vector<Point> permitted_coordinates(const Fragment& fragment) const;

  const ScenePrimitive& primitive_of(const Fragment& fragment) const;
  // Computed on demand.
  const PrimitiveValues& values_of(const Fragment& fragment) const;

 private:
  std::optional<Invocation> invocation_of(const Fragment& fragment) const;

  int bits_;
  ShadingRate rate_;
  Interval fixed_unit_;
  LookupLimits lookup_limits_;
  std::function<PixelTruth(const Fragment&)> looked_up_;
  std::vector<const Fragment*> strays_;  // ascending
  SamplePositions positions_;
  // Computed on demand for each primitive; some kilobytes each.
  mutable std::vector<std::unique_ptr<PrimitiveValues>> values_;
};

// Each appends disagreements (beyond what is permitted) and aggregates (inside it) to `result`.
// `exact`: drawn under the context's policy.

// Colours and depths, as the renderer reports them per fragment.
void compare_fragment_values(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, Result& result);

// gl_FragCoord and derivatives of the colour, if they were requested and reported.
void compare_coordinates(const ValueContext& context, const Rendering& exact,
                         const Rendering& rendered, Result& result);
void compare_derivatives(const ValueContext& context, const Rendering& rendered, Result& result);

// Compares the depth buffer, of multisampled targets sample by sample, with the last fragment that
// the renderer reports there.
void compare_depths(const ValueContext& context, const Rendering& rendered, Result& result);

// Compares pixels, of multisampled targets sample by sample, with the last fragment that the
// renderer reports there.
void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result);

// Compares the pixels of one colour with each other, on a target of one sample: dithering is
// disabled.
void compare_dithering(const ValueContext& context, const Rendering& rendered, Result& result);

// True if the answer equals exact to the bit, as most do if colours are flat; then none of its
// values need be judged. Exact is drawn by OpenGL's own choices, and the answer reports everything
// that exact does about fragments and the target, bit by bit. Then every value is correct, and so
// permitted. Only for drawings with one sample each, without passes, textures, fragment operations
// and polygon offset, and for answers without details: elsewhere false, which means unknown.
bool has_exact_values(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
                      const Rendering& rendered);

// The policy's choices, with OpenGL's own on attributes.
RuleChoices lawful_choices(const RuleChoices& chosen);

// Every depth that a primitive may have at a point of the window, with its vertices and its polygon
// offset as free as the specification leaves them.
Interval depth_permitted_at(const PrimitiveValues& values, Point place);

// `permitted`, of one of the primitive's data, with all that a mean of what the polygon's vertices
// carry may be: anything between the least and the greatest of them, which lie in the window. Only
// `permitted` if the primitive is no such polygon. Rulings 44 and 66 contest what is not on the
// triangle's plane.
Interval with_means(Interval permitted, const ScenePrimitive& primitive,
                    const PrimitiveValues& values, const Interpolant& datum);

// `permitted`, of a value that exact computes as the specification does, extended to include the
// exact value rounded to float32: exact is never accused. The exact value is left out if a renderer
// reports a fragment that the primitive cannot have, whose location is nowhere in it.
Interval holding(Interval permitted, double exact);

// The permitted values wherever in a pixel of a multisampled target the attribute is evaluated: at
// least one corner of a convex region. A quotient of linear functions has its extremes at corners,
// unless its denominator passes through 0 between them.
Interval permitted_within(const Interpolant& interpolant, const Interpolant& inverse_w,
                          std::span<const PermittedPlace> corners);

// Value disagreements at a pixel, not legal and without a sample. primitive -1: the pixel. ruling
// 0: the rule's own.
DisagreementClass value_class(int primitive, RuleId rule, int ruling = 0);
// Puts it under the rule and the rule's own ruling.
void put_under(RuleId rule, DisagreementClass& of);
// The pixel's centre, marked.
Figure value_figure(PixelPosition pixel);
// A disagreement of the class, with the figure.
Disagreement value_disagreement(PixelPosition pixel, int primitive, RuleId rule, int ruling = 0);

// Distance between neighbouring float32 values at `value`.
double float_ulp(double value);
// The distance of two numbers in units of the last place of the larger; at most 2^24 beside a zero
// crossing, where the unit of the exact value is hardly defined, or if one of them is infinite.
double error_in_ulp(double exact, double rendered);
// The largest absolute value at a vertex.
double largest_value(const Interpolant& interpolant);
// Largest less least of the values at the vertices; 0 if float32 could hardly distinguish them.
double range_of(const Interpolant& interpolant);

// Counts the values of one attribute that differ inside the permitted range, and keeps the worst.
class ValueAggregator {
 public:
  // ruling 0: the rule's own
  ValueAggregator(std::string attribute, RuleId rule, int ruling = 0, Cause cause = {});

  const std::string& attribute() const { return aggregate_.attribute; }

  // Counts a compared location with so many components, or several such locations.
  void count_compared(std::size_t components, std::size_t places = 1);
  // Counts as many as another aggregator, from which a part of the values was taken.
  void count_as(const ValueAggregator& whole);
  // The errors of one location: call add_error for each component that differs, then add_place
  // once. `range`: of the attribute, for the relative error.
  struct Error {
    int component = 0;
    double exact = 0;
    double rendered = 0;
    double ulp = 0;
    double range = 0;
    std::optional<Interval> permitted{};  // where no fragment tells the value
  };
  void add_error(ValueAggregate::Place place, const Error& error);
  void add_place(ValueAggregate::Place place) { aggregate_.differing.push_back(place); }
  // Appends the aggregate to the result, if anything was compared: passes are counted in whole.
  // compare() leaves out aggregates without a difference.
  void flush(Result& result);

 private:
  ValueAggregate aggregate_;
  double ulp_sum_ = 0;
};

}  // namespace edgecase
