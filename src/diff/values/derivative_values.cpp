// SPDX-License-Identifier: MIT
//
// Derivatives of the colour per fragment (ruling 16).
//
// A derivative that comes of the policy's method, every operation inexact, is aggregated. One that
// does not is held against the other methods: the method that explains most fragments of a case,
// along both axes, is named first, so that the neighbours of a quad do not get two names where one
// will do. A method that is not open explains only what the specification does not permit.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diff/values/value_causes.h"
#include "diff/values/value_diff.h"
#include "diff/values/value_judge.h"
#include "rules/all_rules.h"
#include "rules/values/derivative.h"

namespace edgecase {
namespace {

constexpr int kRuling = 16;
constexpr int kRulingOnAreas = 49;

// A fragment's derivative along one axis.
struct Told {
  const Fragment* fragment;
  const FragmentDetail* detail;
  Derivative derivative;
  unsigned explained_by = 0;  // bit i: the way number i yields it
};

// A way of taking differences: a method, and from which end rows of quads are counted.
struct Way {
  DerivativeMethod method;
  RowOrder rows;
};

// All ways that can differ in a target, those with the policy's rows first.
std::vector<Way> ways_of(RowOrder chosen, const Target& target) {
  std::vector<RowOrder> orders{chosen};
  if (target.height % 2 != 0)
    orders.push_back(chosen == RowOrder::bottom_up ? RowOrder::top_down : RowOrder::bottom_up);
  std::vector<Way> ways;
  for (const RowOrder rows : orders)
    for (const DerivativeMethod method : values_of<DerivativeMethod>())
      ways.push_back({method, rows});
  return ways;
}

const std::array<double, 4>& rendered_of(const Told& told) {
  return *told.detail->derivatives[static_cast<std::size_t>(told.derivative)];
}

// What is permitted of the colours of each primitive.
class PermittedColors {
 public:
  explicit PermittedColors(const ValueContext& context) : context_(context) {}

  // `area`: whatever area of up to 4x4 pixels shares a derivative (ruling 49).
  bool contain(const Told& told, bool area = false) {
    const PrimitiveValues& values = context_.values_of(*told.fragment);
    const auto at =
        primitives_.try_emplace(told.fragment->primitive, values.lawful.color, values.reach).first;
    const PixelPosition pixel{told.fragment->x, told.fragment->y};
    for (std::size_t c = 0; c < 4; ++c) {
      const double rendered = rendered_of(told)[c];
      if (!std::isfinite(rendered)) return false;
      Interval range = area ? at->second.in_area(pixel, told.derivative, c)
                            : at->second.at(pixel, told.derivative, c);
      if (values.is_polygon) {
        // The difference of any two means.
        const Interval means = with_means(values.lawful.color[c].values[0],
                                          context_.primitive_of(*told.fragment), values, c);
        range = hull(range, means - means);
      }
      if (height_of_column(context_.primitive_of(*told.fragment), context_.scene.target) != Fixed())
        range = hull(range, differences_across(*told.fragment, c));
      if (!rounded_to_float(range).contains(to_float(rendered))) return false;
    }
    return true;
  }

 private:
  // Each of a wide line's fragments may have what another row of its column has (ruling 13): the
  // difference of any two values that it may have there and at the eight pixels around.
  Interval differences_across(const Fragment& fragment, std::size_t component) const {
    const ScenePrimitive& line = context_.primitive_of(fragment);
    const Fixed half = Fixed::from_raw(height_of_column(line, context_.scene.target).raw() / 2);
    const PrimitiveValues& values = context_.values_of(fragment);
    const Interpolant& lawful = values.lawful.color[component];
    Interval all = interpolate_exact(lawful, pixel_centre(fragment.x, fragment.y));
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Point at = pixel_centre(fragment.x + dx, fragment.y + dy);
        const PermittedPlace place(values.moved(), at);
        all = hull(all, permitted_across(lawful, values.moved(), place, at, half));
      }
    return all - all;
  }

  const ValueContext& context_;
  std::map<int, PermittedDerivatives> primitives_;  // by the primitive's number
};

// dFdx and dFdy of one form: a policy chooses one method for both.
class DerivativeComparison {
 public:
  DerivativeComparison(const ValueContext& context, PermittedColors& permitted, std::size_t form)
      : context_(context),
        permitted_(permitted),
        chosen_{context.choices.values.derivatives[form], context.choices.values.quad_rows},
        ways_(ways_of(chosen_.rows, context.scene.target)),
        kinds_{static_cast<Derivative>(2 * form), static_cast<Derivative>(2 * form + 1)},
        rule_(derivative_rule_of(kinds_[0])),
        aggregators_{ValueAggregator(name_of(kinds_[0]), rule_, kRuling),
                     ValueAggregator(name_of(kinds_[1]), rule_, kRuling)} {}

  void run(const Rendering& rendered, Result& result) {
    std::vector<Told> others;
    for (const Fragment& f : rendered.fragments) {
      if (f.detail < 0) continue;
      const FragmentDetail& detail = rendered.details[static_cast<std::size_t>(f.detail)];
      for (const Derivative derivative : kinds_)
        if (detail.derivatives[static_cast<std::size_t>(derivative)])
          sort({&f, &detail, derivative}, others);
    }
    name_ways(std::move(others), result);
    for (ValueAggregator& aggregator : aggregators_) aggregator.flush(result);
  }

 private:
  // What the policy's method yields is aggregated, the rest is kept.
  void sort(const Told& told, std::vector<Told>& others) {
    aggregator_of(told).count_compared(4);
    const bool agrees = yields(told, chosen_);
    (agrees ? agreeing_ : others).push_back(told);
    if (agrees) aggregate(told);
  }

  ValueAggregator& aggregator_of(const Told& told) {
    return aggregators_[told.derivative == kinds_[0] ? 0 : 1];
  }

  QuadPixel place_of(const Told& told, RowOrder rows) const {
    return in_quad({told.fragment->x, told.fragment->y}, rows, context_.scene.target.height);
  }

  const std::array<Interpolant, 4>& colors_of(const Told& told) const {
    return context_.values_of(*told.fragment).chosen.color;
  }

  // A flat colour is copied, not computed (ruling 8): its differences are zero by any method.
  bool is_flat(const Told& told) const {
    return context_.primitive_of(*told.fragment).state->interpolation == Interpolation::flat;
  }

  bool yields(const Told& told, const Way& way) const {
    if (is_flat(told)) return rendered_of(told) == std::array<double, 4>{};
    return yields_derivative(colors_of(told), place_of(told, way.rows), told.derivative, way.method,
                             rendered_of(told));
  }

  // The fine forms take immediate neighbours; of the others an area is spoken of.
  bool is_of_larger_area(const Told& told) const {
    return form_of(told.derivative) != form_of(Derivative::x_fine) && !is_flat(told) &&
           permitted_.contain(told, true);
  }

  bool is_permitted(const Told& told) const {
    if (is_flat(told)) return rendered_of(told) == std::array<double, 4>{};
    return permitted_.contain(told);
  }

  std::array<double, 4> exact_of(const Told& told) const {
    std::array<double, 4> result;
    for (std::size_t c = 0; c < 4; ++c)
      result[c] = middle(derivative_exact(colors_of(told)[c], place_of(told, chosen_.rows),
                                          axis_of(told.derivative), chosen_.method));
    return result;
  }

  void aggregate(const Told& told) {
    const ValueAggregate::Place place{told.fragment->x, told.fragment->y, told.fragment->primitive};
    ValueAggregator& aggregator = aggregator_of(told);
    const std::array<double, 4> exact = exact_of(told);
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const double rendered = rendered_of(told)[c];
      if (to_float(exact[c]) == to_float(rendered)) continue;
      differs = true;
      aggregator.add_error(place, {static_cast<int>(c), exact[c], rendered,
                                   error_in_ulp(exact[c], rendered), range_of(colors_of(told)[c])});
    }
    if (differs) aggregator.add_place(place);
  }

  bool is_open(DerivativeMethod method) const {
    return find_alternative(rule_of(rule_), name_of(method))->openness == Openness::open;
  }

  // What is permitted needs no method that is not.
  unsigned explaining(const Told& told) const {
    unsigned open = 0;
    unsigned illegal = 0;
    for (std::size_t i = 0; i < ways_.size(); ++i)
      if (yields(told, ways_[i])) (is_open(ways_[i].method) ? open : illegal) |= 1u << i;
    return illegal != 0 && !is_permitted(told) ? open | illegal : open;
  }

  // The way that explains most of these; of several, the one that yields most of what agrees, too:
  // it is one way that a renderer goes everywhere. None if none explains any.
  std::optional<std::size_t> best_way(const std::vector<Told>& others) const {
    const auto explained = [&](std::size_t i) {
      return std::count_if(others.begin(), others.end(),
                           [&](const Told& told) { return (told.explained_by >> i & 1u) != 0; });
    };
    const auto agreeing = [&](std::size_t i) {
      return std::count_if(agreeing_.begin(), agreeing_.end(),
                           [&](const Told& told) { return yields(told, ways_[i]); });
    };
    std::ptrdiff_t most = 0;
    std::vector<std::size_t> tied;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const std::ptrdiff_t count = explained(i);
      if (count > most) tied.clear();
      most = std::max(most, count);
      if (count == most) tied.push_back(i);
    }
    if (most == 0) return std::nullopt;
    if (tied.size() == 1) return tied[0];
    std::vector<std::ptrdiff_t> counts;
    for (const std::size_t i : tied) counts.push_back(agreeing(i));
    return tied[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                         counts.begin())];
  }

  void name_ways(std::vector<Told> others, Result& result) {
    for (Told& told : others) told.explained_by = explaining(told);
    while (const auto best = best_way(others)) {
      const auto rest = std::stable_partition(others.begin(), others.end(), [&](const Told& told) {
        return (told.explained_by >> *best & 1u) == 0;
      });
      for (auto told = rest; told != others.end(); ++told) report(*told, ways_[*best], result);
      others.erase(rest, others.end());
    }
    for (const Told& told : others) {
      if (is_permitted(told))
        aggregate(told);
      else
        report_beyond(told, result);
    }
  }

  Disagreement disagreement(const Told& told) const {
    const Fragment& f = *told.fragment;
    Disagreement d = value_disagreement({f.x, f.y}, f.primitive, rule_, kRuling);
    const std::array<double, 4> exact = exact_of(told);
    d.exact.assign(exact.begin(), exact.end());
    d.rendered.assign(rendered_of(told).begin(), rendered_of(told).end());
    d.explanation = fmt::format("{} of primitive {} is ({:.9g}) by {}; the renderer's ({:.9g}) ",
                                name_of(told.derivative), f.primitive, fmt::join(d.exact, ", "),
                                name_of(chosen_.method), fmt::join(d.rendered, ", "));
    return d;
  }

  void report(const Told& told, const Way& way, Result& result) const {
    Disagreement d = disagreement(told);
    if (way.method != chosen_.method)
      d.cause.parts.push_back(alternative_id(rule_, name_of(way.method)));
    if (way.rows != chosen_.rows)
      d.cause.parts.push_back(alternative_id(RuleId::derivative_quad_rows, name_of(way.rows)));
    d.legality = by_letter(is_open(way.method));
    d.explanation += fmt::format("comes of {}", name_of(way.method));
    if (way.rows != chosen_.rows)
      d.explanation += fmt::format(", rows of quads counted {}", name_of(way.rows));
    result.disagreements.push_back(std::move(d));
  }

  void report_beyond(const Told& told, Result& result) const {
    Disagreement d = disagreement(told);
    if (!is_flat(told))
      d.cause = cause_of_derivatives(context_, *told.fragment, *told.detail, kinds_);
    if (is_by_major_axis(d.cause)) d.ruling = kRulingOnLineValues;
    if (d.cause.empty() && is_of_larger_area(told)) d.ruling = kRulingOnAreas;
    d.explanation += "is no difference of neighbours that the specification permits";
    if (!d.cause.empty()) d.explanation += fmt::format(", but one under {}", text_of(d.cause));
    result.disagreements.push_back(std::move(d));
  }

  const ValueContext& context_;
  PermittedColors& permitted_;
  Way chosen_;
  std::vector<Way> ways_;
  std::array<Derivative, 2> kinds_;
  RuleId rule_;
  std::array<ValueAggregator, 2> aggregators_;
  std::vector<Told> agreeing_;
};

}  // namespace

void compare_derivatives(const ValueContext& context, const Rendering& rendered, Result& result) {
  if (rendered.details.empty()) return;
  PermittedColors permitted(context);
  for (std::size_t form = 0; form < kDerivatives / 2; ++form)
    DerivativeComparison(context, permitted, form).run(rendered, result);
}

}  // namespace edgecase
