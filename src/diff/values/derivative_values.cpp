// SPDX-License-Identifier: MIT
//
// Derivatives of the colour per fragment (ruling 16).
//
// A derivative that the policy's method yields, every operation inexact, is aggregated. Any other
// is tested with the other methods: the method that explains most fragments of a case, along both
// axes, is named first, so that neighbours in a quad do not get two names where one suffices. A
// method that is not open explains only what the specification does not permit.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/values/flat_values.h"
#include "diff/values/value_causes.h"
#include "diff/values/value_diff.h"
#include "diff/values/value_judge.h"
#include "rules/all_rules.h"
#include "rules/values/attributes.h"
#include "rules/values/derivative.h"

namespace edgecase {
namespace {

constexpr int kRuling = 16;

// A fragment's derivative along one axis.
struct ReportedDerivative {
  const Fragment* fragment;
  const FragmentDetail* detail;
  Derivative derivative;
  unsigned explained_by = 0;  // bit i: way number i yields it
};

// A way of taking differences: a method, and the end from which rows of quads are counted.
struct Way {
  DerivativeMethod method;
  RowOrder rows;
};

// All ways that can differ on a target, those with the policy's rows first.
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

const std::array<double, 4>& rendered_of(const ReportedDerivative& reported) {
  return *reported.detail->derivatives[static_cast<std::size_t>(reported.derivative)];
}

// The permitted derivatives of each primitive's colours.
class PermittedColors {
 public:
  explicit PermittedColors(const ValueContext& context) : context_(context) {}

  // `area`: for any area of up to 4x4 pixels that shares a derivative (ruling 49).
  bool contain(const ReportedDerivative& reported, bool area = false) {
    const PrimitiveValues& values = context_.values_of(*reported.fragment);
    const auto at =
        primitives_.try_emplace(reported.fragment->primitive, values.lawful.color, values.reach)
            .first;
    const PixelPosition pixel{reported.fragment->x, reported.fragment->y};
    for (std::size_t c = 0; c < 4; ++c) {
      const double rendered = rendered_of(reported)[c];
      if (!std::isfinite(rendered)) return false;
      Interval range = area ? at->second.in_area(pixel, reported.derivative, c)
                            : at->second.at(pixel, reported.derivative, c);
      if (values.is_polygon) {
        // The difference of any two means.
        const Interpolant& lawful = values.lawful.color[c];
        const Interval means =
            with_means(interpolate_exact(lawful, pixel_centre(pixel.x, pixel.y)),
                       context_.primitive_of(*reported.fragment), values, lawful);
        range = hull(range, means - means);
      }
      if (height_of_column(context_.primitive_of(*reported.fragment), context_.scene.target) !=
          Fixed())
        range = hull(range, differences_across(*reported.fragment, c));
      if (!rounded_to_float(range).contains(to_float(rendered))) return false;
    }
    return true;
  }

 private:
  // Each fragment of a wide line may have the value of another row of its column (ruling 13): the
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
  std::map<int, PermittedDerivatives> primitives_;  // by primitive index
};

// dFdx and dFdy of one form; a policy chooses one method for both.
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
    std::vector<ReportedDerivative> others;
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
  // Aggregates what the policy's method yields, and keeps the rest.
  void sort(const ReportedDerivative& reported, std::vector<ReportedDerivative>& others) {
    aggregator_of(reported).count_compared(4);
    const bool agrees = yields(reported, chosen_);
    (agrees ? agreeing_ : others).push_back(reported);
    if (agrees) aggregate(reported);
  }

  ValueAggregator& aggregator_of(const ReportedDerivative& reported) {
    return aggregators_[reported.derivative == kinds_[0] ? 0 : 1];
  }

  QuadPixel place_of(const ReportedDerivative& reported, RowOrder rows) const {
    return in_quad({reported.fragment->x, reported.fragment->y}, rows,
                   context_.scene.target.height);
  }

  const std::array<Interpolant, 4>& colors_of(const ReportedDerivative& reported) const {
    return context_.values_of(*reported.fragment).chosen.color;
  }

  // A flat colour is copied, not computed (ruling 8): its differences are zero by any method.
  bool is_flat(const ReportedDerivative& reported) const {
    return context_.primitive_of(*reported.fragment).state->interpolation == Interpolation::flat;
  }

  bool yields(const ReportedDerivative& reported, const Way& way) const {
    if (is_flat(reported)) return rendered_of(reported) == std::array<double, 4>{};
    return yields_derivative(colors_of(reported), place_of(reported, way.rows), reported.derivative,
                             way.method, rendered_of(reported));
  }

  // The fine forms take immediate neighbours; for the others, the specification speaks of an area.
  bool is_of_larger_area(const ReportedDerivative& reported) const {
    return form_of(reported.derivative) != form_of(Derivative::x_fine) && !is_flat(reported) &&
           permitted_.contain(reported, true);
  }

  bool is_permitted(const ReportedDerivative& reported) const {
    if (is_flat(reported)) return rendered_of(reported) == std::array<double, 4>{};
    return permitted_.contain(reported);
  }

  std::array<double, 4> exact_of(const ReportedDerivative& reported) const {
    std::array<double, 4> result;
    for (std::size_t c = 0; c < 4; ++c)
      result[c] = middle(derivative_exact(colors_of(reported)[c], place_of(reported, chosen_.rows),
                                          axis_of(reported.derivative), chosen_.method));
    return result;
  }

  void aggregate(const ReportedDerivative& reported) {
    const ValueAggregate::Place place{reported.fragment->x, reported.fragment->y,
                                      reported.fragment->primitive};
    ValueAggregator& aggregator = aggregator_of(reported);
    const std::array<double, 4> exact = exact_of(reported);
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const double rendered = rendered_of(reported)[c];
      if (to_float(exact[c]) == to_float(rendered)) continue;
      differs = true;
      aggregator.add_error(
          place, {static_cast<int>(c), exact[c], rendered, error_in_ulp(exact[c], rendered),
                  range_of(colors_of(reported)[c])});
    }
    if (differs) aggregator.add_place(place);
  }

  bool is_open(DerivativeMethod method) const {
    return find_alternative(rule_of(rule_), name_of(method))->openness == Openness::open;
  }

  // A permitted value needs no method that is illegal.
  unsigned explaining(const ReportedDerivative& reported) const {
    unsigned open = 0;
    unsigned illegal = 0;
    for (std::size_t i = 0; i < ways_.size(); ++i)
      if (yields(reported, ways_[i])) (is_open(ways_[i].method) ? open : illegal) |= 1u << i;
    return illegal != 0 && !is_permitted(reported) ? open | illegal : open;
  }

  // The way that explains most of these; of several, the one that yields most of the agreeing
  // values, since a renderer goes one way everywhere. None if no way explains any.
  std::optional<std::size_t> best_way(const std::vector<ReportedDerivative>& others) const {
    const auto explained = [&](std::size_t i) {
      return std::count_if(others.begin(), others.end(), [&](const ReportedDerivative& reported) {
        return (reported.explained_by >> i & 1u) != 0;
      });
    };
    const auto agreeing = [&](std::size_t i) {
      return std::count_if(
          agreeing_.begin(), agreeing_.end(),
          [&](const ReportedDerivative& reported) { return yields(reported, ways_[i]); });
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

  void name_ways(std::vector<ReportedDerivative> others, Result& result) {
    for (ReportedDerivative& reported : others) reported.explained_by = explaining(reported);
    while (const auto best = best_way(others)) {
      const auto rest = std::stable_partition(others.begin(), others.end(),
                                              [&](const ReportedDerivative& reported) {
                                                return (reported.explained_by >> *best & 1u) == 0;
                                              });
      for (auto reported = rest; reported != others.end(); ++reported)
        report(*reported, ways_[*best], result);
      others.erase(rest, others.end());
    }
    for (const ReportedDerivative& reported : others) {
      if (is_permitted(reported))
        aggregate(reported);
      else
        report_beyond(reported, result);
    }
  }

  Disagreement disagreement(const ReportedDerivative& reported) const {
    const Fragment& f = *reported.fragment;
    Disagreement d = value_disagreement({f.x, f.y}, f.primitive, rule_, kRuling);
    const std::array<double, 4> exact = exact_of(reported);
    d.exact.assign(exact.begin(), exact.end());
    d.rendered.assign(rendered_of(reported).begin(), rendered_of(reported).end());
    d.explanation = fmt::format("{} of primitive {} is ({:.9g}) by {}; the renderer's ({:.9g}) ",
                                name_of(reported.derivative), f.primitive, fmt::join(d.exact, ", "),
                                name_of(chosen_.method), fmt::join(d.rendered, ", "));
    return d;
  }

  void report(const ReportedDerivative& reported, const Way& way, Result& result) const {
    Disagreement d = disagreement(reported);
    if (way.method != chosen_.method)
      d.cause.parts.push_back(alternative_id(rule_, name_of(way.method)));
    if (way.rows != chosen_.rows)
      d.cause.parts.push_back(alternative_id(RuleId::derivative_quad_rows, name_of(way.rows)));
    d.legality = by_letter(is_open(way.method));
    d.explanation += fmt::format("comes of {}", name_of(way.method));
    if (way.rows != chosen_.rows)
      d.explanation += fmt::format(", rows of quads counted {}", name_of(way.rows));
    add_disagreement(result, std::move(d));
  }

  void report_beyond(const ReportedDerivative& reported, Result& result) const {
    Disagreement d = disagreement(reported);
    if (!is_flat(reported))
      d.cause = cause_of_derivatives(context_, *reported.fragment, *reported.detail, kinds_);
    if (is_by_major_axis(d.cause)) {
      d.ruling = kRulingOnLineValues;
      d.legality = by_letter(may_go_by_major_axis(context_, *reported.fragment));
    }
    if (d.cause.empty() && is_of_larger_area(reported)) d.ruling = kRulingOnLargerAreas;
    d.explanation += "is no difference of neighbours that the specification permits";
    if (!d.cause.empty()) d.explanation += fmt::format(", but one under {}", text_of(d.cause));
    add_disagreement(result, std::move(d));
  }

  const ValueContext& context_;
  PermittedColors& permitted_;
  Way chosen_;
  std::vector<Way> ways_;
  std::array<Derivative, 2> kinds_;
  RuleId rule_;
  std::array<ValueAggregator, 2> aggregators_;
  std::vector<ReportedDerivative> agreeing_;
};

}  // namespace

void compare_derivatives(const ValueContext& context, const Rendering& rendered, Result& result) {
  if (rendered.details.empty()) return;
  PermittedColors permitted(context);
  for (std::size_t form = 0; form < kDerivatives / 2; ++form)
    DerivativeComparison(context, permitted, form).run(rendered, result);
}

}  // namespace edgecase
