// SPDX-License-Identifier: MIT
#include "diff/textures/texture_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/textures/texture_ways.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// What one comparison of lookups is about: the level of detail, or the colour.
struct Subject {
  const char* attribute;
  RuleId rule;
  int ruling;
  const char* words;  // of an explanation: "the level of detail of …"
  bool is_query;      // of the level, by textureQueryLod
};

constexpr Subject kLevels{"level of detail", RuleId::texture_scale_factor, 19,
                          "level accessed and lambda'", true};
constexpr Subject kColors{"texture color", RuleId::texture_filter, 24, "looked-up colour", false};

// One lookup that a renderer told of.
struct Told {
  const Fragment* fragment;
  std::vector<double> exact;
  std::vector<double> rendered;
};

bool is_same(double a, double b) {
  return to_float(a) == to_float(b) || (std::isnan(a) && std::isnan(b));
}

// Where anything may be, so may what is no number.
bool range_has(Interval range, double number) {
  if (std::isnan(range.low) || std::isnan(range.high)) return true;
  if (std::isnan(number)) return std::isinf(range.low) && std::isinf(range.high);
  return rounded_to_float(range).contains(to_float(number));
}

bool hold(const Boxes& boxes, const std::vector<double>& numbers) {
  return std::ranges::any_of(boxes, [&](const std::vector<Interval>& box) {
    for (std::size_t c = 0; c < box.size(); ++c)
      if (!range_has(box[c], numbers[c])) return false;
    return true;
  });
}

// The smallest box around all others, in words: "1 to 2, 0.5 to 0.75".
std::string range_words(const Boxes& boxes) {
  std::vector<Interval> all = boxes.front();
  for (const std::vector<Interval>& box : boxes)
    for (std::size_t c = 0; c < box.size(); ++c) all[c] = hull(all[c], box[c]);
  std::string text;
  for (const Interval range : all)
    text += fmt::format("{}{:.9g} to {:.9g}", text.empty() ? "" : ", ", range.low, range.high);
  return text;
}

// In units of the last place; what is no number, and an infinity for a number, is as far off as any
// two numbers of different signs.
double error_of(double exact, double rendered) {
  return std::isfinite(exact) && std::isfinite(rendered) ? error_in_ulp(exact, rendered) : 0x1p24;
}

constexpr int kRulingOnAnisotropy = 23;
constexpr int kRulingOnAnisotropicHull = 57;
constexpr int kRulingOnPrecision = 50;
constexpr int kRulingOnSrgb = 53;

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
        aggregator_(subject.attribute, subject.rule, subject.ruling) {}

  // Whether the policy's own way yields what the renderer tells.
  bool add(const Fragment& fragment, std::span<const double> exact, Result& result) {
    Told told{&fragment, {exact.begin(), exact.end()}, rendered_of(fragment)};
    aggregator_.count_compared(told.exact.size());
    const bool is_correct = std::ranges::equal(told.exact, told.rendered, is_same);
    const bool agrees = is_correct || hold(under(told, chosen_, {}), told.rendered);
    const bool is_rounded =
        !agrees && may_round(told) && hold(under(told, chosen_, {true, false}), told.rendered);
    if (!agrees && !is_rounded) {
      others_.push_back(std::move(told));
    } else if (is_judged_ && !is_permitted(told)) {
      report_policy(told, is_correct, result);
    } else if (is_rounded) {
      rounded_.push_back(std::move(told));
    } else {
      if (!is_correct) aggregate(told);
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
    // In the order in which people read them.
    std::map<std::string, ValueAggregator*> by_text;
    for (auto& [cause, aggregator] : by_cause_) by_text.emplace(text_of(cause), &aggregator);
    for (const auto& [text, aggregator] : by_text) {
      aggregator->count_as(aggregator_);
      aggregator->flush(result);
    }
  }

  // Of those that the policy's own way does not yield; after finish().
  const WaysOfLevels& ways() const { return ways_; }

 private:
  using Reach = TextureLookups::Reach;

  // How a lookup is put to the test: with means rounded to codes, by the level that the renderer
  // tells.
  struct Terms {
    bool rounding = false;
    bool as_told = false;
  };

  // What the renderer tells.
  std::vector<double> rendered_of(const Fragment& fragment) const {
    if (!subject_.is_query) return {fragment.color.begin(), fragment.color.end()};
    const auto& told = *lookups_.detail_of(fragment)->level_of_detail;
    return {told.begin(), told.end()};
  }

  // All that a lookup may yield under a choice, and at most.
  Boxes under(const Told& told, const TextureChoice& choice, Terms terms) const {
    const Fragment& fragment = *told.fragment;
    return subject_.is_query ? lookups_.levels(fragment, choice)
                             : lookups_.colors(fragment, choice, terms.rounding, terms.as_told);
  }
  bool tells_level(const Told& told) const {
    return !subject_.is_query && lookups_.tells_level(*told.fragment);
  }
  bool may_round(const Told& told) const {
    return !subject_.is_query && lookups_.may_round(*told.fragment);
  }
  Boxes at_most(const Told& told, Reach reach = Reach::all) const {
    return subject_.is_query ? lookups_.permitted_levels(*told.fragment, reach)
                             : lookups_.permitted_colors(*told.fragment, reach);
  }
  bool is_permitted(const Told& told) const {
    return hold(at_most(told, Reach::near), told.rendered) || hold(at_most(told), told.rendered);
  }

  // By which a lookup that is not permitted is judged: what coarse samplers yield is contested.
  int ruling_on(const Told& told) const {
    if (lookups_.use_of(*told.fragment).sampler.max_anisotropy > 1)
      return subject_.is_query || lookups_.has_levels_of_one_color(*told.fragment)
                 ? kRulingOnAnisotropy
                 : kRulingOnAnisotropicHull;
    if (hold(at_most(told, Reach::coarse), told.rendered)) return kRulingOnPrecision;
    if (!subject_.is_query && hold(at_most(told, Reach::coarse_srgb), told.rendered))
      return kRulingOnSrgb;
    return subject_.ruling;
  }

  LookupKinship kinship_of(const Told& told, bool as_told) const {
    LookupKinship kin = lookups_.kinship_of(*told.fragment, subject_.is_query);
    kin.is_level_given = as_told && tells_level(told);
    return kin;
  }

  // The aggregate of what an open way yields; a way of one alternative is about that one's rule.
  ValueAggregator& aggregator_of(const Cause& cause) {
    return by_cause_
        .try_emplace(cause, subject_.attribute, rule_about(cause), subject_.ruling, cause)
        .first->second;
  }

  RuleId rule_about(const Cause& cause) const {
    return cause.size() == 1 ? cause.rule() : subject_.rule;
  }

  void aggregate(const Told& told) { aggregate(told, aggregator_); }

  void aggregate(const Told& told, ValueAggregator& aggregator) {
    const Fragment& f = *told.fragment;
    const ValueAggregate::Place place{f.x, f.y, f.primitive};
    for (std::size_t c = 0; c < told.exact.size(); ++c) {
      const double exact = told.exact[c];
      const double rendered = told.rendered[c];
      if (is_same(exact, rendered)) continue;
      aggregator.add_error(place,
                           {static_cast<int>(c), exact, rendered, error_of(exact, rendered), 0});
    }
    aggregator.add_place(place);
  }

  // The kinds of those that need explaining.
  std::vector<LookupKinship> kinds_of(const std::vector<Told>& lookups, bool as_told) const {
    std::vector<LookupKinship> kinds;
    for (const Told& told : lookups) {
      const LookupKinship kin = kinship_of(told, as_told);
      const bool is_new = std::ranges::none_of(kinds, [&](const LookupKinship& known) {
        return known.use == kin.use && known.has_perspective == kin.has_perspective &&
               known.is_level_given == kin.is_level_given;
      });
      if (is_new) kinds.push_back(kin);
    }
    return kinds;
  }

  // Does a lookup come out so under a choice? `own`: under the policy's own.
  bool yields(const Told& told, const TextureChoice& choice, bool own, Terms terms) const {
    const LookupKinship kin = kinship_of(told, terms.as_told);
    if (relevant_part(choice, kin) == relevant_part(chosen_, kin)) return own;
    terms.as_told = kin.is_level_given;
    const bool is_about_level = !terms.as_told || subject_.is_query;
    if (is_about_level && !lookups_.is_definite(*told.fragment, choice, subject_.is_query))
      return false;
    return hold(under(told, choice, terms), told.rendered);
  }

  std::vector<std::optional<TextureWay>> ways_of(const std::vector<Told>& lookups,
                                                 Terms terms) const {
    const auto yields_other = [&](std::size_t i, const TextureChoice& choice) {
      return yields(lookups[i], choice, false, terms);
    };
    const auto yields_agreeing = [&](std::size_t i, const TextureChoice& choice) {
      const Fragment& fragment = *agreeing_[i];
      return yields({&fragment, {}, rendered_of(fragment)}, choice, true, terms);
    };
    return TextureWaySearch(chosen_, profile_, kinds_of(lookups, terms.as_told))
        .explain({lookups.size(), agreeing_.size(), yields_other, yields_agreeing});
  }

  // Half a code hides much. Where a renderer does not round to codes, a way shows all the same: a
  // few lookups tell whether there is one.
  void name_rounded_ways() {
    constexpr std::size_t kProbes = 8;
    std::vector<Told> probes;
    for (const std::size_t i : sample_of(rounded_.size(), kProbes)) probes.push_back(rounded_[i]);
    const auto ways = ways_of(probes, {});
    const auto& way = ways.front();
    const bool is_common =
        way && way->open &&
        2 * std::ranges::count_if(
                ways, [&](const auto& other) { return other && other->cause == way->cause; }) >=
            std::ssize(ways);
    for (const Told& told : rounded_) {
      if (is_common && yields(told, way->choice, false, {}))
        aggregate(told, aggregator_of(way->cause));
      else
        aggregate(told);
    }
  }

  // A colour that the renderer's own level explains goes the way that the level goes.
  void follow_levels(const WaysOfLevels& levels) {
    std::erase_if(others_, [&](const Told& told) {
      const auto way = levels.find(told.fragment);
      if (way == levels.end() || !tells_level(told)) return false;
      if (!hold(under(told, chosen_, {true, true}), told.rendered)) return false;
      aggregate(told, way->second.open ? aggregator_of(way->second.cause) : aggregator_);
      return true;
    });
  }

  // By the levels that the renderer tells, and what remains by those that it should have.
  std::vector<std::optional<TextureWay>> ways_of_others() const {
    auto ways = ways_of(others_, {true, true});
    if (std::ranges::none_of(others_, [&](const Told& told) { return tells_level(told); }))
      return ways;
    std::vector<Told> rest;
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
  }

  Disagreement disagreement(const Told& told) const {
    const Fragment& f = *told.fragment;
    Disagreement d = value_disagreement({f.x, f.y}, f.primitive, subject_.rule, ruling_on(told));
    d.exact = told.exact;
    d.rendered = told.rendered;
    d.explanation = fmt::format(
        "the {} of primitive {} is exactly ({:.9g}); the renderer has ({:.9g})", subject_.words,
        f.primitive, fmt::join(d.exact, ", "), fmt::join(d.rendered, ", "));
    return d;
  }

  void blame(Disagreement& d, const Cause& cause) const {
    d.cause = cause;
    d.explanation += fmt::format(", which comes of {}", text_of(cause));
    d.rule = rule_about(cause);
  }

  void tell_permitted(const Told& told, Disagreement& d) const {
    d.explanation += fmt::format("; the specification permits {}", range_words(at_most(told)));
  }

  // Beyond what is permitted, whether or not a way that is not open leads there.
  void report(const Told& told, const std::optional<TextureWay>& way, Result& result) const {
    Disagreement d = disagreement(told);
    if (way) blame(d, way->cause);
    tell_permitted(told, d);
    result.disagreements.push_back(std::move(d));
  }

  // What a policy has that OpenGL forbids.
  void report_policy(const Told& told, bool is_correct, Result& result) const {
    Disagreement d = disagreement(told);
    d.policy_agrees = is_correct;
    blame(d, illegal_part(relevant_part(chosen_, kinship_of(told, false))));
    tell_permitted(told, d);
    result.disagreements.push_back(std::move(d));
  }

  TextureLookups& lookups_;
  const Subject& subject_;
  const TextureChoice* profile_;
  TextureChoice chosen_;
  bool is_judged_;              // the policy has what OpenGL forbids, and OpenGL judges
  ValueAggregator aggregator_;  // of the policy's own way
  std::map<Cause, ValueAggregator> by_cause_;  // of open ways
  std::vector<Told> others_;                   // that the policy's own way does not yield
  std::vector<Told> rounded_;                  // that it yields where means are rounded to codes
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
