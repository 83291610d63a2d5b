// SPDX-License-Identifier: MIT
#include "diff/textures/texture_lookups.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/textures/lookup_kinship.h"
#include "diff/textures/texture_ways.h"
#include "rules/all_rules.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/texel_filter.h"

namespace edgecase {
namespace {

// The subject of one comparison of lookups: the level of detail, or the colour.
struct Subject {
  const char* attribute;
  RuleId rule;
  const char* text;  // for explanations: "the level of detail of …"
  bool is_query;     // textureQueryLod asks for the level
};

constexpr Subject kLevels{"level of detail", RuleId::texture_scale_factor,
                          "level accessed and lambda'", true};
constexpr Subject kColors{"texture color", RuleId::texture_filter, "looked-up colour", false};

// A lookup that a renderer reported.
struct ReportedLookup {
  const Fragment* fragment;
  LookupNumbers exact;
  LookupNumbers rendered;
};

bool is_same(double a, double b) {
  return to_float(a) == to_float(b) || (std::isnan(a) && std::isnan(b));
}

// In units of the last place. NaN, and an infinity in place of a number, count like two numbers of
// different signs.
double error_of(double exact, double rendered) {
  return std::isfinite(exact) && std::isfinite(rendered) ? error_in_ulp(exact, rendered) : 0x1p24;
}

constexpr int kRulingOnAnisotropy = 23;

using WaysOfLevels = std::map<const Fragment*, TextureWay>;

class LookupComparison {
 public:
  LookupComparison(const ValueContext& context, TextureLookups& lookups, const Subject& subject,
                   const TextureChoice* profile)
      : lookups_(lookups),
        subject_(subject),
        profile_(profile),
        chosen_(context.choices.textures),
        is_judged_(context.latitude != Latitude::none && !illegal_part(chosen_).empty()),
        aggregator_(subject.attribute, subject.rule) {}

  // Returns true if the policy's own way yields what the renderer reports.
  bool add(const Fragment& fragment, std::span<const double> exact, Result& result) {
    ReportedLookup lookup{&fragment, {exact.begin(), exact.end()}, rendered_of(fragment)};
    aggregator_.count_compared(lookup.exact.size());
    const bool is_correct = std::ranges::equal(lookup.exact, lookup.rendered, is_same);
    const Fit fit = is_correct ? Fit::whole : fit_of(lookup, chosen_, false);
    if (fit == Fit::none) {
      others_.push_back(std::move(lookup));
    } else if (is_judged_ && !is_permitted(lookup)) {
      report_policy(lookup, is_correct, result);
    } else if (fit == Fit::rounded) {
      rounded_.push_back(std::move(lookup));
    } else {
      if (!is_correct) aggregate(lookup);
      agreeing_.push_back(&fragment);
      return true;
    }
    return false;
  }

  // `levels`: the ways of the same fragments' levels of detail.
  void finish(const WaysOfLevels& levels, Result& result) {
    if (!rounded_.empty()) name_rounded_ways();
    follow_levels(levels);
    if (!others_.empty()) name_ways(result);
    aggregator_.flush(result);
    // Sorted by text, for readers.
    std::map<std::string, ValueAggregator*> by_text;
    for (auto& [cause, aggregator] : by_cause_) by_text.emplace(text_of(cause), &aggregator);
    for (const auto& [text, aggregator] : by_text) {
      aggregator->count_as(aggregator_);
      aggregator->flush(result);
    }
  }

  // The ways of lookups that the policy's own way does not yield; valid after finish().
  const WaysOfLevels& ways() const { return ways_; }

 private:
  using Reach = TextureLookups::Reach;

  // The terms on which a lookup is tested: means rounded to codes, and the level that the renderer
  // reports.
  struct Terms {
    bool rounding = false;
    bool as_reported = false;
  };

  // The values that the renderer reports.
  LookupNumbers rendered_of(const Fragment& fragment) const {
    if (!subject_.is_query) return {fragment.color.begin(), fragment.color.end()};
    const auto& lookup = *lookups_.detail_of(fragment)->level_of_detail;
    return {lookup.begin(), lookup.end()};
  }

  // Whether a lookup may have its result under a choice: as it is, or if means are rounded to
  // codes.
  enum class Fit { none, rounded, whole };
  Fit fit_of(const ReportedLookup& lookup, const TextureChoice& choice, bool as_reported) const {
    const Fragment& fragment = *lookup.fragment;
    if (subject_.is_query)
      return hold(lookups_.levels(fragment, choice), lookup.rendered) ? Fit::whole : Fit::none;
    const Texels colors = lookups_.colors(fragment, choice, as_reported);
    if (hold(lookups_.widened(fragment, colors, false), lookup.rendered)) return Fit::whole;
    const bool is_rounded = lookups_.may_round(fragment) &&
                            hold(lookups_.widened(fragment, colors, true), lookup.rendered);
    return is_rounded ? Fit::rounded : Fit::none;
  }
  bool fits(const ReportedLookup& lookup, const TextureChoice& choice, Terms terms) const {
    const Fit fit = fit_of(lookup, choice, terms.as_reported);
    return fit == Fit::whole || (fit == Fit::rounded && terms.rounding);
  }
  bool reports_level(const ReportedLookup& lookup) const {
    return !subject_.is_query && lookups_.reports_level(*lookup.fragment);
  }
  // All results that are permitted.
  Boxes at_most(const ReportedLookup& lookup, Reach reach = Reach::all) const {
    return subject_.is_query ? lookups_.permitted_levels(*lookup.fragment, reach)
                             : lookups_.permitted_colors(*lookup.fragment, reach);
  }
  bool is_permitted(const ReportedLookup& lookup) const {
    return hold(at_most(lookup, Reach::near), lookup.rendered) ||
           hold(at_most(lookup), lookup.rendered);
  }

  // The ruling on a lookup that is not permitted; results of coarse samplers are contested.
  int ruling_on(const ReportedLookup& lookup) const {
    if (lookups_.use_of(*lookup.fragment).sampler.max_anisotropy > 1)
      return !subject_.is_query && !lookups_.has_levels_of_one_color(*lookup.fragment) &&
                     hold(lookups_.overshooting_colors(*lookup.fragment), lookup.rendered)
                 ? kRulingOnAnisotropicHull
                 : kRulingOnAnisotropy;
    if (hold(at_most(lookup, Reach::coarse), lookup.rendered)) return kRulingOnPrecision;
    if (!subject_.is_query && hold(at_most(lookup, Reach::coarse_srgb), lookup.rendered))
      return kRulingOnSrgb;
    return rule_of(subject_.rule).ruling;
  }

  LookupKinship kinship_of(const ReportedLookup& lookup, bool as_reported) const {
    LookupKinship kin = lookups_.kinship_of(*lookup.fragment, subject_.is_query);
    kin.is_level_given = as_reported && reports_level(lookup);
    return kin;
  }

  // The aggregate of an open way; if the way is a single alternative, under that one's rule.
  ValueAggregator& aggregator_of(const Cause& cause) {
    return by_cause_
        .try_emplace(cause, subject_.attribute, rule_about(cause), rule_of(subject_.rule).ruling,
                     cause)
        .first->second;
  }

  RuleId rule_about(const Cause& cause) const {
    return cause.size() == 1 ? cause.rule() : subject_.rule;
  }

  void aggregate(const ReportedLookup& lookup) { aggregate(lookup, aggregator_); }

  void aggregate(const ReportedLookup& lookup, ValueAggregator& aggregator) {
    const Fragment& f = *lookup.fragment;
    const ValueAggregate::Place place{f.x, f.y, f.primitive};
    for (std::size_t c = 0; c < lookup.exact.size(); ++c) {
      const double exact = lookup.exact[c];
      const double rendered = lookup.rendered[c];
      if (is_same(exact, rendered)) continue;
      aggregator.add_error(place,
                           {static_cast<int>(c), exact, rendered, error_of(exact, rendered), 0});
    }
    aggregator.add_place(place);
  }

  // The kinds of lookups that need an explanation.
  std::vector<LookupKinship> kinds_of(const std::vector<ReportedLookup>& lookups,
                                      bool as_reported) const {
    std::vector<LookupKinship> kinds;
    for (const ReportedLookup& lookup : lookups) {
      const LookupKinship kin = kinship_of(lookup, as_reported);
      const bool is_new = std::ranges::none_of(kinds, [&](const LookupKinship& known) {
        return known.use == kin.use && known.has_perspective == kin.has_perspective &&
               known.is_level_given == kin.is_level_given;
      });
      if (is_new) kinds.push_back(kin);
    }
    return kinds;
  }

  // True if a choice yields the lookup. `own`: the result for a choice equal to the policy's own.
  bool yields(const ReportedLookup& lookup, const TextureChoice& choice, bool own,
              Terms terms) const {
    const LookupKinship kin = kinship_of(lookup, terms.as_reported);
    if (relevant_part(choice, kin) == relevant_part(chosen_, kin)) return own;
    terms.as_reported = kin.is_level_given;
    const bool is_about_level = !terms.as_reported || subject_.is_query;
    if (is_about_level && !lookups_.is_definite(*lookup.fragment, choice, subject_.is_query))
      return false;
    return fits(lookup, choice, terms);
  }

  // `ask` gets the search and the lookups that it is about.
  template <class Ask>
  auto searched(const std::vector<ReportedLookup>& lookups, Terms terms, const Ask& ask) const {
    const auto yields_other = [&](std::size_t i, const TextureChoice& choice) {
      return yields(lookups[i], choice, false, terms);
    };
    const auto yields_agreeing = [&](std::size_t i, const TextureChoice& choice) {
      const Fragment& fragment = *agreeing_[i];
      return yields({&fragment, {}, rendered_of(fragment)}, choice, true, terms);
    };
    return ask(TextureWaySearch(chosen_, profile_, kinds_of(lookups, terms.as_reported)),
               WaySearchLookups{lookups.size(), agreeing_.size(), yields_other, yields_agreeing});
  }

  std::vector<std::optional<TextureWay>> ways_of(const std::vector<ReportedLookup>& lookups,
                                                 Terms terms) const {
    return searched(lookups, terms,
                    [](const auto& search, const auto& of) { return search.explain(of); });
  }

  // What all lookups beyond the permitted may come of.
  void add_evidence(Result& result) const {
    std::vector<ReportedLookup> beyond;
    std::ranges::copy_if(others_, std::back_inserter(beyond),
                         [&](const ReportedLookup& lookup) { return !is_permitted(lookup); });
    if (beyond.empty()) return;
    const auto common = [](const auto& search, const auto& of) { return search.common(of); };
    std::vector<Cause> causes = searched(beyond, {true, false}, common);
    if (!causes.empty()) result.evidence.push_back({kAllValues, std::move(causes), {}, ""});
  }

  // Half a code hides many ways. If a renderer does not round to codes, a way shows nevertheless: a
  // few lookups reveal whether there is one.
  void name_rounded_ways() {
    constexpr std::size_t kProbes = 8;
    std::vector<ReportedLookup> probes;
    for (const std::size_t i : sample_of(rounded_.size(), kProbes)) probes.push_back(rounded_[i]);
    const auto ways = ways_of(probes, {});
    const auto& way = ways.front();
    const bool is_common =
        way && way->open &&
        2 * std::ranges::count_if(
                ways, [&](const auto& other) { return other && other->cause == way->cause; }) >=
            std::ssize(ways);
    for (const ReportedLookup& lookup : rounded_) {
      if (is_common && yields(lookup, way->choice, false, {}))
        aggregate(lookup, aggregator_of(way->cause));
      else
        aggregate(lookup);
    }
  }

  // A colour that the renderer's own level explains goes the way of the level.
  void follow_levels(const WaysOfLevels& levels) {
    std::erase_if(others_, [&](const ReportedLookup& lookup) {
      const auto way = levels.find(lookup.fragment);
      if (way == levels.end() || !reports_level(lookup)) return false;
      if (!fits(lookup, chosen_, {true, true})) return false;
      aggregate(lookup, way->second.open ? aggregator_of(way->second.cause) : aggregator_);
      return true;
    });
  }

  // By the levels that the renderer reports first; the rest by the levels that it should have.
  std::vector<std::optional<TextureWay>> ways_of_others() const {
    auto ways = ways_of(others_, {true, true});
    if (std::ranges::none_of(others_,
                             [&](const ReportedLookup& lookup) { return reports_level(lookup); }))
      return ways;
    std::vector<ReportedLookup> rest;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (ways[i]) continue;
      rest.push_back(others_[i]);
      places.push_back(i);
    }
    const auto of_rest = ways_of(rest, {true, false});
    for (std::size_t i = 0; i < rest.size(); ++i) ways[places[i]] = of_rest[i];
    return ways;
  }

  void name_ways(Result& result) {
    const auto ways = ways_of_others();
    // Bounds decide what is legal, whichever way leads there.
    for (std::size_t i = 0; i < others_.size(); ++i) {
      if (ways[i]) ways_.emplace(others_[i].fragment, *ways[i]);
      if (!is_permitted(others_[i]))
        report(others_[i], ways[i], result);
      else if (ways[i] && ways[i]->open)
        aggregate(others_[i], aggregator_of(ways[i]->cause));
      else
        aggregate(others_[i]);
    }
    add_evidence(result);
  }

  Disagreement disagreement(const ReportedLookup& lookup) const {
    const Fragment& f = *lookup.fragment;
    Disagreement d = value_disagreement({f.x, f.y}, f.primitive, subject_.rule, ruling_on(lookup));
    d.exact.assign(lookup.exact.begin(), lookup.exact.end());
    d.rendered.assign(lookup.rendered.begin(), lookup.rendered.end());
    d.explanation = fmt::format(
        "the {} of primitive {} is exactly ({:.9g}); the renderer has ({:.9g})", subject_.text,
        f.primitive, fmt::join(d.exact, ", "), fmt::join(d.rendered, ", "));
    return d;
  }

  void blame(Disagreement& d, const Cause& cause) const {
    d.cause = cause;
    d.explanation += fmt::format(", which comes of {}", text_of(cause));
    d.rule = rule_about(cause);
  }

  void append_permitted(const ReportedLookup& lookup, Disagreement& d) const {
    d.explanation += fmt::format("; the specification permits {}", describe_range(at_most(lookup)));
  }

  // Reports a lookup beyond the permitted range, whether or not an illegal way explains it.
  void report(const ReportedLookup& lookup, const std::optional<TextureWay>& way,
              Result& result) const {
    Disagreement d = disagreement(lookup);
    if (way) blame(d, way->cause);
    append_permitted(lookup, d);
    add_disagreement(result, std::move(d));
  }

  // Reports choices of a policy that OpenGL forbids.
  void report_policy(const ReportedLookup& lookup, bool is_correct, Result& result) const {
    Disagreement d = disagreement(lookup);
    d.policy_agrees = is_correct;
    blame(d, illegal_part(relevant_part(chosen_, kinship_of(lookup, false))));
    append_permitted(lookup, d);
    add_disagreement(result, std::move(d));
  }

  TextureLookups& lookups_;
  const Subject& subject_;
  const TextureChoice* profile_;
  TextureChoice chosen_;
  bool is_judged_;              // OpenGL judges, and the policy chooses what it forbids
  ValueAggregator aggregator_;  // of the policy's own way
  std::map<Cause, ValueAggregator> by_cause_;  // of open ways
  std::vector<ReportedLookup> others_;         // lookups that the policy's own way does not yield
  std::vector<ReportedLookup> rounded_;        // lookups it yields if means are rounded to codes
  std::vector<const Fragment*> agreeing_;
  WaysOfLevels ways_;
};

}  // namespace

void compare_texture_lookups(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, const TextureChoice* profile,
                             Result& result) {
  if (context.scene.textures.empty()) return;
  TextureLookups lookups(context, exact, rendered);
  LookupComparison levels(context, lookups, kLevels, profile);
  LookupComparison colors(context, lookups, kColors, profile);
  for (const Fragment& f : rendered.fragments) {
    Patience::check();
    if (!context.primitive_of(f).state->texture) continue;
    const LookedUp own = lookups.exact(f);
    const FragmentDetail* detail = lookups.detail_of(f);
    bool agrees = true;
    if (detail != nullptr && detail->level_of_detail)
      agrees = levels.add(f, own.level_of_detail, result);
    if (f.has_color) agrees = colors.add(f, own.color, result) && agrees;
    if (agrees) lookups.forget(f);
  }
  levels.finish({}, result);
  colors.finish(levels.ways(), result);
}

}  // namespace edgecase
